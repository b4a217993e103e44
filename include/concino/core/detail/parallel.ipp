// Loops on threads of their own; see parallel.hpp.
#pragma once

#include <concino/core/parallel.hpp>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <exception>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace concino::core {

CONCINO_INLINE std::size_t num_threads() {
  constexpr long most = 1024;
  if (const char* const text = std::getenv("CONCINO_NUM_THREADS"))
    if (const long n = std::strtol(text, nullptr, 10); n > 0) return static_cast<std::size_t>(std::min(n, most));
  return std::max(1u, std::thread::hardware_concurrency());
}

CONCINO_INLINE void for_each_chunk(std::size_t chunks, function_ref<void(std::size_t)> run, function_ref<bool(double)> stop) {
  const std::size_t threads = chunks > 1 ? std::min(num_threads(), chunks) : 1;
  if (threads == 1) {
    for (std::size_t c = 0; c < chunks; ++c) {
      run(c);
      if (stop && stop(static_cast<double>(c + 1) / static_cast<double>(chunks))) return;
    }
    return;
  }

  constexpr std::size_t none = static_cast<std::size_t>(-1);
  struct failure {
    std::size_t chunk = none;
    std::exception_ptr what;
  };
  std::atomic<std::size_t> next{0}, done{0}, first_failed{none};
  std::atomic<bool> stopped{false};
  const auto work = [&](failure& own, bool is_calling_thread) {
    while (!stopped.load(std::memory_order_relaxed)) {
      const std::size_t c = next.fetch_add(1, std::memory_order_relaxed);
      if (c >= chunks || c > first_failed.load(std::memory_order_relaxed)) return;
      try {
        run(c);
        const std::size_t finished = done.fetch_add(1, std::memory_order_relaxed) + 1;
        if (is_calling_thread && stop && stop(static_cast<double>(finished) / static_cast<double>(chunks))) stopped = true;
      } catch (...) {
        own = {c, std::current_exception()};  // chunks come in order: all before c have been begun, and are finished
        std::size_t lowest = first_failed.load();
        while (c < lowest && !first_failed.compare_exchange_weak(lowest, c)) {}
        return;
      }
    }
  };

  std::vector<failure> failures(threads);
  std::vector<std::thread> others;
  others.reserve(threads - 1);
  try {
    while (others.size() + 1 < threads) others.emplace_back([&work, &own = failures[others.size() + 1]] { work(own, false); });
  } catch (const std::system_error&) {  // the system has no more threads: those that there are do the work
  } catch (const std::bad_alloc&) {
  }
  work(failures[0], true);
  for (std::thread& t : others) t.join();
  for (const failure& f : failures)
    if (f.chunk != none && f.chunk == first_failed.load()) std::rethrow_exception(f.what);
}

}  // namespace concino::core
