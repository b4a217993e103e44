// Parallel loops on threads; see parallel.hpp. The threads are those of POSIX: <thread> and <mutex> take a tenth of the time in which a program that reads one
// format is compiled.
#pragma once

#include <concino/core/parallel.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <new>
#include <vector>

#include <pthread.h>
#include <unistd.h>
#ifdef __linux__
#include <sched.h>
#endif

namespace concino::core {

CONCINO_INLINE std::size_t num_threads() {
  constexpr long most = 1024;
  if (const char* const text = std::getenv("CONCINO_NUM_THREADS"))
    if (const long n = std::strtol(text, nullptr, 10); n > 0) return static_cast<std::size_t>(std::min(n, most));
#ifdef __linux__
  ::cpu_set_t allowed;  // sysconf() counts cores that the process may not run on
  if (::sched_getaffinity(0, sizeof allowed, &allowed) == 0) return static_cast<std::size_t>(std::max(1, CPU_COUNT(&allowed)));
#endif
  return static_cast<std::size_t>(std::clamp(::sysconf(_SC_NPROCESSORS_ONLN), 1L, most));
}

/// Locks a mutex until it is destroyed, or unlock() is called.
class mutex_lock {
  ::pthread_mutex_t& mutex_;
  bool is_locked_ = false;

 public:
  explicit mutex_lock(::pthread_mutex_t& mutex) : mutex_(mutex) { lock(); }
  mutex_lock(const mutex_lock&) = delete;
  mutex_lock& operator=(const mutex_lock&) = delete;
  ~mutex_lock() { unlock(); }

  void lock() {
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

  /// Call it after the threads have ended.
  void rethrow() const {
    if (what_) std::rethrow_exception(what_);
  }
};

/// The threads that help the calling one. The destructor joins them, however the loop ends.
class part_helpers {
  shared_parts& parts_;
  std::vector<::pthread_t> threads_;

 public:
  explicit part_helpers(shared_parts& parts) : parts_(parts) {}
  part_helpers(const part_helpers&) = delete;
  part_helpers& operator=(const part_helpers&) = delete;
  ~part_helpers() {
    if (threads_.empty()) return;
    parts_.leave_out_rest();
    join();
  }

  std::size_t size() const { return threads_.size(); }

  /// Starts up to n more threads. Returns false if the system or memory does not allow all: those that were started do the work.
  bool start(std::size_t n) {
    try {
      threads_.reserve(threads_.size() + n);
    } catch (const std::bad_alloc&) {
      return false;
    }
    const auto run = [](void* parts) -> void* {
      while (static_cast<shared_parts*>(parts)->run_next()) {}
      return nullptr;
    };
    for (; n > 0; --n) {
      ::pthread_t thread;
      if (::pthread_create(&thread, nullptr, run, &parts_) != 0) return false;
      threads_.push_back(thread);
    }
    return true;
  }

  void join() {
    for (const ::pthread_t t : threads_) ::pthread_join(t, nullptr);
    threads_.clear();
  }
};

/// The time of day: where somebody sets it meanwhile, threads start sooner or later. No <chrono>, which takes long to compile.
inline std::int64_t nanoseconds() {
  std::timespec now = {};
  std::timespec_get(&now, TIME_UTC);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

/// run_parts with `at_once` helper threads that start before the first part, if not 0, and no others. After each part on the calling thread, calls
/// stop(number of parts done), if there is one.
inline void run_shared(function_ref<bool(function_ref<void()>)> run, function_ref<bool(std::size_t)> stop, std::size_t at_once) {
  constexpr std::int64_t worth_a_thread = 200'000;  // nanoseconds: many times the cost of starting and joining one
  constexpr std::size_t unknown = static_cast<std::size_t>(-1);
  shared_parts parts(run);
  part_helpers helpers(parts);
  std::size_t most = unknown;  // number of helpers; determined when the first may be worth its cost
  if (at_once > 0) {
    helpers.start(at_once);
    most = helpers.size();
  }
  std::int64_t since = nanoseconds();
  for (bool is_more = true; is_more;) {
    is_more = helpers.size() == 0 ? parts.run_next_alone() : parts.run_next();
    if (stop && stop(parts.num_done())) {
      parts.leave_out_rest();
      break;
    }
    if (!is_more || helpers.size() >= most) continue;
    if (const std::int64_t spent = nanoseconds() - since; spent >= 0 && spent < worth_a_thread) continue;
    if (most == unknown) most = num_threads() - 1;
    if (!helpers.start(std::min(helpers.size() + 1, most - helpers.size()))) most = helpers.size();
    since = nanoseconds();
  }
  helpers.join();
  parts.rethrow();
}

/// Calls run(first, last) for the chunks of 0 to n.
inline void run_shared_chunks(std::size_t n, std::size_t chunk, function_ref<void(std::size_t, std::size_t)> run, function_ref<bool(double)> stop,
                              std::size_t at_once) {
  if (n == 0) return;
  const std::size_t chunks = n / chunk + (n % chunk != 0);
  const auto stop_after = [&](std::size_t done) { return stop(static_cast<double>(std::min(done, chunks)) / static_cast<double>(chunks)); };
  std::size_t next = 0;
  run_shared(
      [&](function_ref<void()> release) {
        const std::size_t first = next, last = n - first < chunk ? n : first + chunk;
        next = last;
        if (release) release();
        if (first < last) run(first, last);
        return last < n;
      },
      stop ? function_ref<bool(std::size_t)>(stop_after) : nullptr, at_once);
}

CONCINO_INLINE void run_parts(function_ref<bool(function_ref<void()>)> run) { run_shared(run, nullptr, 0); }

CONCINO_INLINE void run_chunks(std::size_t n, std::size_t chunk, function_ref<void(std::size_t, std::size_t)> run, function_ref<bool(double)> stop) {
  run_shared_chunks(n, chunk == 0 ? 1 : chunk, run, stop, 0);
}

CONCINO_INLINE void for_each_chunk(std::size_t chunks, function_ref<void(std::size_t)> run) {
  const auto run_one = [&](std::size_t c, std::size_t) { run(c); };
  run_shared_chunks(chunks, 1, run_one, nullptr, chunks > 1 ? std::min(num_threads(), chunks) - 1 : 0);
}

}  // namespace concino::core
