// Threads that help another one with its loops, one loop after another.
#pragma once

#include <concino/core/detail/shared_parts.hpp>

#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

#include <pthread.h>
#include <sched.h>

namespace concino::core {

/// The helper threads of one calling thread. Between two loops they look for the next one in a loop for as long as it would take to wake them, and then
/// sleep. The destructor joins them.
class helper_threads {
  static constexpr std::uint64_t is_open = 1, one_inside = 2, one_loop = std::uint64_t{1} << 32;  // the number of the loop is state / one_loop

  shared_parts* parts_ = nullptr;  // of the loop, while it is open or helpers are inside
  std::uint64_t state_ = 0;        // atomic: whether the loop is open to helpers, how many of them are inside, and its number
  std::uint32_t asleep_ = 0;       // atomic; written under the lock. How many helpers sleep
  std::uint32_t is_caller_asleep_ = 0, is_over_ = 0;  // the same
  ::pthread_mutex_t mutex_ = PTHREAD_MUTEX_INITIALIZER;
  ::pthread_cond_t loop_begins_ = PTHREAD_COND_INITIALIZER, helpers_leave_ = PTHREAD_COND_INITIALIZER;
  std::vector<::pthread_t> threads_;

 public:
  /// Nanoseconds that it takes, at most, until a thread that is started or woken runs.
  static constexpr std::int64_t time_to_start = 200'000;

  helper_threads() = default;
  helper_threads(const helper_threads&) = delete;
  helper_threads& operator=(const helper_threads&) = delete;
  ~helper_threads() {
    end();
    for (const ::pthread_t t : threads_) ::pthread_join(t, nullptr);
  }

  std::size_t size() const { return threads_.size(); }

  /// Lets the helpers end, without waiting for it. No loop may be opened afterwards.
  void end() {
    if (threads_.empty()) return;
    const mutex_lock lock(mutex_);
    __atomic_store_n(&is_over_, 1, __ATOMIC_SEQ_CST);
    if (asleep_ > 0) ::pthread_cond_broadcast(&loop_begins_);
  }

  /// Starts up to n more threads, which run(this) and call help(). Returns false if the system or memory does not allow all: those that were started do the work.
  bool start(std::size_t n, void* (*run)(void*)) {
    try {
      threads_.reserve(threads_.size() + n);
    } catch (const std::bad_alloc&) {
      return false;
    }
    for (; n > 0; --n) {
      ::pthread_t thread;
      if (::pthread_create(&thread, nullptr, run, this) != 0) return false;
      threads_.push_back(thread);
    }
    return true;
  }

  /// Lets the helpers take parts of a loop.
  void open(shared_parts& parts) {
    parts_ = &parts;
    __atomic_store_n(&state_, (__atomic_load_n(&state_, __ATOMIC_RELAXED) / one_loop + 1) * one_loop | is_open, __ATOMIC_SEQ_CST);
    if (__atomic_load_n(&asleep_, __ATOMIC_SEQ_CST) == 0) return;
    const mutex_lock lock(mutex_);
    ::pthread_cond_broadcast(&loop_begins_);
  }

  /// Waits until the helpers have finished the parts that they have taken.
  void close() {
    __atomic_fetch_and(&state_, ~is_open, __ATOMIC_SEQ_CST);
    if (wait_in_loop([this] { return num_inside() == 0; })) return;
    const mutex_lock lock(mutex_);
    __atomic_store_n(&is_caller_asleep_, 1, __ATOMIC_SEQ_CST);
    while (num_inside() > 0) ::pthread_cond_wait(&helpers_leave_, &mutex_);
    __atomic_store_n(&is_caller_asleep_, 0, __ATOMIC_SEQ_CST);
  }

  /// What a helper does.
  void help() {
    for (std::uint64_t last = 0;;) {  // the number of the loop in which this helper found nothing more to do
      const auto is_called = [&] { return __atomic_load_n(&is_over_, __ATOMIC_SEQ_CST) || is_new(__atomic_load_n(&state_, __ATOMIC_SEQ_CST), last); };
      if (!wait_in_loop(is_called)) {
        const mutex_lock lock(mutex_);
        __atomic_store_n(&asleep_, asleep_ + 1, __ATOMIC_SEQ_CST);
        while (!is_called()) ::pthread_cond_wait(&loop_begins_, &mutex_);
        __atomic_store_n(&asleep_, asleep_ - 1, __ATOMIC_SEQ_CST);
      }
      if (__atomic_load_n(&is_over_, __ATOMIC_SEQ_CST)) return;
      std::uint64_t now = __atomic_load_n(&state_, __ATOMIC_SEQ_CST);
      if (!is_new(now, last) || !__atomic_compare_exchange_n(&state_, &now, now + one_inside, false, __ATOMIC_SEQ_CST, __ATOMIC_SEQ_CST)) continue;
      last = now / one_loop;
      while (parts_->run_next()) {}
      if (__atomic_sub_fetch(&state_, one_inside, __ATOMIC_SEQ_CST) % one_loop != 0 || !__atomic_load_n(&is_caller_asleep_, __ATOMIC_SEQ_CST)) continue;
      const mutex_lock lock(mutex_);
      ::pthread_cond_signal(&helpers_leave_);
    }
  }

 private:
  static bool is_new(std::uint64_t state, std::uint64_t last) { return (state & is_open) && state / one_loop != last; }
  std::uint64_t num_inside() const { return __atomic_load_n(&state_, __ATOMIC_SEQ_CST) % one_loop / one_inside; }

  /// Asks again and again, for as long as it would take to wake a thread. Returns whether the answer was yes. Other threads may have the core in between.
  template<class Condition>
  static bool wait_in_loop(const Condition& holds) {
    for (const std::int64_t since = nanoseconds();;) {
      for (int i = 0; i < 64; ++i, pause_in_loop())
        if (holds()) return true;
      if (const std::int64_t spent = nanoseconds() - since; spent < 0 || spent > time_to_start) return false;
      ::sched_yield();
    }
  }
};

}  // namespace concino::core
