// Parallel loops on threads; see parallel.hpp.
#pragma once

#include <concino/core/detail/helper_threads.hpp>
#include <concino/core/parallel.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <new>

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

/// What the loops of a thread have to know: the helpers of its thread_team, if these have nothing to do, and whether it runs a part of a loop that
/// several threads share.
struct loop_context {
  helper_threads* idle = nullptr;
  bool is_in_loop = false;
};
inline constinit thread_local loop_context context_of_thread;

inline void* run_helper(void* threads) {
  context_of_thread.is_in_loop = true;
  static_cast<helper_threads*>(threads)->help();
  return nullptr;
}

/// The helpers of one loop: those of the call's thread_team if they are idle, else new ones. The destructor waits for them, however the loop ends.
class loop_helpers {
  shared_parts& parts_;
  loop_context& context_;
  const loop_context before_;
  helper_threads own_;
  helper_threads& threads_;
  bool is_open_ = false;

  void close() {
    if (!is_open_) return;
    threads_.close();
    context_ = before_;
    is_open_ = false;
  }

 public:
  explicit loop_helpers(shared_parts& parts)
      : parts_(parts), context_(context_of_thread), before_(context_), threads_(before_.idle ? *before_.idle : own_) {}
  loop_helpers(const loop_helpers&) = delete;
  loop_helpers& operator=(const loop_helpers&) = delete;
  ~loop_helpers() {
    if (is_open_) parts_.leave_out_rest();
    close();
  }

  bool is_open() const { return is_open_; }
  std::size_t size() const { return threads_.size(); }
  /// Starts up to n more; see helper_threads.
  bool start(std::size_t n) { return threads_.start(n, run_helper); }
  /// Lets the helpers take parts, if there are helpers.
  void open() {
    if (is_open_ || size() == 0) return;
    context_ = {nullptr, true};
    is_open_ = true;
    threads_.open(parts_);
  }
  void finish() {
    close();
    parts_.rethrow();
  }
};

/// run_parts. Helper threads that the call's thread_team has take parts from the beginning if `soon`, else after the first part. If there are none,
/// `at_once` are started before the first part; if that is 0, some when the loop turns out to be long. After each part on the calling thread, calls
/// stop(number of parts done), if there is one.
inline void run_shared(function_ref<bool(function_ref<void()>)> run, function_ref<bool(std::size_t)> stop, bool soon, std::size_t at_once) {
  constexpr std::size_t unknown = static_cast<std::size_t>(-1);
  shared_parts parts(run);
  loop_helpers helpers(parts);
  std::size_t most = unknown;  // number of helpers; determined when the first may be worth its cost
  if (at_once > 0) {
    if (at_once > helpers.size()) helpers.start(at_once - helpers.size());
    most = helpers.size();
  }
  if (soon) helpers.open();
  std::int64_t since = nanoseconds();
  for (bool is_more = true; is_more;) {
    is_more = helpers.is_open() ? parts.run_next() : parts.run_next_alone();
    if (stop && stop(parts.num_done())) {
      parts.leave_out_rest();
      break;
    }
    if (!is_more) break;
    helpers.open();
    if (helpers.size() >= most) continue;
    if (const std::int64_t spent = nanoseconds() - since; spent >= 0 && spent < helper_threads::time_to_start) continue;
    if (most == unknown) most = num_threads() - 1;
    if (helpers.size() < most && !helpers.start(std::min(helpers.size() + 1, most - helpers.size()))) most = helpers.size();
    helpers.open();
    since = nanoseconds();
  }
  helpers.finish();
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
      stop ? function_ref<bool(std::size_t)>(stop_after) : nullptr, chunks > 1, at_once);
}

CONCINO_INLINE void run_parts(function_ref<bool(function_ref<void()>)> run) { run_shared(run, nullptr, false, 0); }

CONCINO_INLINE void run_chunks(std::size_t n, std::size_t chunk, function_ref<void(std::size_t, std::size_t)> run, function_ref<bool(double)> stop) {
  run_shared_chunks(n, chunk == 0 ? 1 : chunk, run, stop, 0);
}

CONCINO_INLINE void for_each_chunk(std::size_t chunks, function_ref<void(std::size_t)> run) {
  const auto run_one = [&](std::size_t c, std::size_t) { run(c); };
  run_shared_chunks(chunks, 1, run_one, nullptr, chunks > 1 ? std::min(num_threads(), chunks) - 1 : 0);
}

CONCINO_INLINE thread_team::thread_team(bool is_long) {
  loop_context& context = context_of_thread;
  if (!is_long || context.idle || context.is_in_loop || num_threads() == 1) return;
  helpers_ = new (std::nothrow) helper_threads;
  if (!helpers_) return;
  helpers_->start(1, run_helper);
  context.idle = helpers_;
}

CONCINO_INLINE void thread_team::finish() {
  if (!helpers_) return;
  context_of_thread.idle = nullptr;
  helpers_->end();
}

CONCINO_INLINE thread_team::~thread_team() {
  finish();
  delete helpers_;
}

}  // namespace concino::core
