// Parallel loops on std::thread; see parallel.hpp. No other header of concino starts threads.
#pragma once

#include <concino/core/parallel.hpp>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <latch>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#ifdef __linux__
#include <sched.h>
#endif

namespace concino::core {

CONCINO_INLINE std::size_t num_threads() {
  constexpr long most = 1024;
  if (const char* const text = std::getenv("CONCINO_NUM_THREADS"))
    if (const long n = std::strtol(text, nullptr, 10); n > 0) return static_cast<std::size_t>(std::min(n, most));
#ifdef __linux__
  ::cpu_set_t allowed;  // hardware_concurrency() counts cores that the process may not run on
  if (::sched_getaffinity(0, sizeof allowed, &allowed) == 0)
    return static_cast<std::size_t>(std::max(1, CPU_COUNT(&allowed)));
#endif
  return std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, most);
}

/// Whether this thread runs chunks of a loop that several threads share.
inline constinit thread_local bool is_in_shared_loop = false;

/// The chunks of a loop, which threads take in order. The destructor leaves out those that were not taken, and waits
/// for the others.
class chunk_loop {
  const std::size_t n_, chunk_, chunks_;
  const function_ref<void(std::size_t, std::size_t)> run_;
  std::mutex mutex_;  // of all below
  std::size_t next_ = 0, done_ = 0, failed_;
  std::exception_ptr error_;  // of chunk failed_, the lowest that has failed
  std::vector<std::thread> helpers_;
  const bool was_in_shared_loop_ = is_in_shared_loop;

  bool take(std::size_t& c) {
    const std::lock_guard lock(mutex_);
    c = next_;
    if (c == chunks_) return false;
    ++next_;
    return true;
  }
  void leave_out_rest() {
    const std::lock_guard lock(mutex_);
    next_ = chunks_;
  }
  void join() {
    for (std::thread& t : helpers_) t.join();
    helpers_.clear();
    is_in_shared_loop = was_in_shared_loop_;
  }

 public:
  chunk_loop(std::size_t n, std::size_t chunk, function_ref<void(std::size_t, std::size_t)> run)
      : n_(n), chunk_(chunk), chunks_(n / chunk + (n % chunk != 0)), run_(run), failed_(chunks_) {}
  chunk_loop(const chunk_loop&) = delete;
  chunk_loop& operator=(const chunk_loop&) = delete;
  ~chunk_loop() {
    leave_out_rest();
    join();
  }

  std::size_t size() const { return chunks_; }

  /// Takes and runs a chunk. Result: false if there was none.
  bool run_next() {
    std::size_t c;
    if (!take(c)) return false;
    std::exception_ptr error;
    try {
      run_(c * chunk_, n_ - c * chunk_ < chunk_ ? n_ : (c + 1) * chunk_);
    } catch (...) {
      error = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    ++done_;
    if (error && c < failed_) {
      failed_ = c;
      error_ = error;
      next_ = chunks_;
    }
    return true;
  }

  /// Starts n threads that run chunks, or as many as the system permits.
  void start(std::size_t n) {
    if (n == 0) return;
    is_in_shared_loop = true;
    helpers_.reserve(n);
    const auto help = [this] {
      is_in_shared_loop = true;
      while (run_next()) {}
    };
    try {
      while (helpers_.size() < n) helpers_.emplace_back(help);
    } catch (const std::system_error&) {
    }
  }

  double fraction() {
    const std::lock_guard lock(mutex_);
    return static_cast<double>(done_) / static_cast<double>(chunks_);
  }

  /// Waits for the chunks that were taken, if there is no other. Errors: that of the lowest chunk.
  void finish() {
    join();
    if (error_) std::rethrow_exception(error_);
  }
};

CONCINO_INLINE void run_chunks(std::size_t n, std::size_t chunk, function_ref<void(std::size_t, std::size_t)> run,
                               function_ref<bool(double)> stop) {
  constexpr std::chrono::microseconds time_to_start(200);
  chunk_loop loop(n, std::max<std::size_t>(chunk, 1), run);
  const auto begin = std::chrono::steady_clock::now();
  for (bool is_shared = is_in_shared_loop; loop.run_next();) {
    if (stop && stop(loop.fraction())) return;
    if (is_shared || std::chrono::steady_clock::now() - begin < time_to_start) continue;
    is_shared = true;
    loop.start(std::min(num_threads(), loop.size()) - 1);
  }
  loop.finish();
}

CONCINO_INLINE void for_each_chunk(std::size_t chunks, function_ref<void(std::size_t)> run) {
  if (chunks == 0) return;
  const auto run_one = [&](std::size_t c, std::size_t) { run(c); };
  chunk_loop loop(chunks, 1, run_one);
  if (!is_in_shared_loop) loop.start(std::min(num_threads(), chunks) - 1);
  while (loop.run_next()) {}
  loop.finish();
}

CONCINO_INLINE void run_twice_at_once(function_ref<void(std::size_t)> run) {
  std::latch both_ready(2);
  std::exception_ptr errors[2];
  const auto run_one = [&](std::size_t i) {
    both_ready.arrive_and_wait();
    try {
      run(i);
    } catch (...) {
      errors[i] = std::current_exception();
    }
  };
  std::thread other(run_one, std::size_t{1});
  run_one(0);
  other.join();
  for (const std::exception_ptr& error : errors)
    if (error) std::rethrow_exception(error);
}

}  // namespace concino::core
