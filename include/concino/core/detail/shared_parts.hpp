// The parts of a loop that several threads share, and a lock for them. The threads are those of POSIX: <thread> and <mutex> take a tenth of the time in
// which a program that reads one format is compiled.
#pragma once

#include <concino/core/function_ref.hpp>

#include <cstddef>
#include <cstdint>
#include <ctime>
#include <exception>

#include <pthread.h>

namespace concino::core {

/// The time of day: where somebody sets it meanwhile, threads start sooner or later. No <chrono>, which takes long to compile.
inline std::int64_t nanoseconds() {
  std::timespec now = {};
  std::timespec_get(&now, TIME_UTC);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

/// Tells the processor that this thread waits for another one in a loop.
inline void pause_in_loop() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#endif
}

/// Locks a mutex until it is destroyed, or unlock() is called. Waits a little before it asks the system: other threads keep these locks for some nanoseconds.
class mutex_lock {
  ::pthread_mutex_t& mutex_;
  bool is_locked_ = false;

 public:
  explicit mutex_lock(::pthread_mutex_t& mutex) : mutex_(mutex) { lock(); }
  mutex_lock(const mutex_lock&) = delete;
  mutex_lock& operator=(const mutex_lock&) = delete;
  ~mutex_lock() { unlock(); }

  void lock() {
    for (int tries = 0; !is_locked_ && tries < 100; ++tries) {
      is_locked_ = ::pthread_mutex_trylock(&mutex_) == 0;
      if (!is_locked_) pause_in_loop();
    }
    if (!is_locked_) ::pthread_mutex_lock(&mutex_);
    is_locked_ = true;
  }
  void unlock() {
    if (is_locked_) ::pthread_mutex_unlock(&mutex_);
    is_locked_ = false;
  }
};

/// The parts of a task, for threads that each take one after another. Parts are taken in order. So when one fails, all earlier ones have been taken
/// and will be finished.
class shared_parts {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  function_ref<bool(function_ref<void()>)> run_;
  ::pthread_mutex_t mutex_ = PTHREAD_MUTEX_INITIALIZER;
  std::size_t taken_ = 0, failed_ = none;
  std::exception_ptr what_;  // of the first part, in order, that failed
  bool is_over_ = false;
  std::size_t done_ = 0;  // atomic

 public:
  explicit shared_parts(function_ref<bool(function_ref<void()>)> run) : run_(run) {}

  std::size_t num_done() const { return __atomic_load_n(&done_, __ATOMIC_RELAXED); }

  /// Runs the next part while there is only one thread. Returns whether more are left.
  bool run_next_alone() {
    const bool is_more = run_(nullptr);
    __atomic_fetch_add(&done_, 1, __ATOMIC_RELAXED);
    return is_more;
  }

  /// The same for one of several threads; exceptions are stored.
  bool run_next() {
    mutex_lock lock(mutex_);
    if (is_over_) return false;
    const std::size_t number = taken_++;
    try {
      const bool is_more = run_([&] { lock.unlock(); });
      __atomic_fetch_add(&done_, 1, __ATOMIC_RELAXED);
      return is_more;
    } catch (...) {
      lock.lock();
      is_over_ = true;
      if (number < failed_) {
        failed_ = number;
        what_ = std::current_exception();
      }
      return false;
    }
  }

  /// Cancels the parts that no thread has taken.
  void leave_out_rest() {
    const mutex_lock lock(mutex_);
    is_over_ = true;
  }

  /// Call it after the helpers have finished.
  void rethrow() const {
    if (what_) std::rethrow_exception(what_);
  }
};

}  // namespace concino::core
