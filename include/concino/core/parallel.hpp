// The one header that loops in parallel. Built with -fopenmp the chunks of a loop run on all cores, built without they run one after
// another; as long as the calls write to different places the result is the same.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <vector>

namespace concino {

/// Calls f(i) for every i in [0, n).
/// Needs:  calls with different i do not write to the same place; chunk > 0 neighbouring indices go to one thread together.
/// Result: as of the plain loop, for any number of threads. `stop` is asked now and then on the calling thread; once it
///         says true the calls not yet begun are left out.                      Cost: n calls, one atomic step per chunk.
/// Errors: what f throws; of several exceptions the one of the lowest chunk, as the plain loop would.
template<class F, class Stop>
void parallel_for(std::size_t n, F&& f, std::size_t chunk, Stop&& stop) {
  if (chunk == 0) chunk = 1;
  const std::size_t chunks = n / chunk + (n % chunk != 0);
  const auto run = [&](std::size_t c) {
    const std::size_t first = c * chunk, last = n - first < chunk ? n : first + chunk;
    for (std::size_t i = first; i < last; ++i) f(i);
  };
#ifdef _OPENMP
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::atomic<std::size_t> failed{none}, done{0};
  std::atomic<bool> stopped{false};
  std::exception_ptr first_exception;
  const auto guarded = [&](std::size_t c, bool on_calling_thread) {
    if (stopped.load(std::memory_order_relaxed) || c > failed.load(std::memory_order_relaxed)) return;
    try {
      run(c);
      const std::size_t finished = done.fetch_add(1, std::memory_order_relaxed) + 1;
      if (on_calling_thread && stop(static_cast<double>(finished) / static_cast<double>(chunks))) stopped = true;
    } catch (...) {
#pragma omp critical(concino_parallel_for)
      if (c < failed) {
        failed = c;
        first_exception = std::current_exception();
      }
    }
  };
#pragma omp parallel if (chunks > 1)
  {
    bool calling = false;
#pragma omp master
    calling = true;
#pragma omp for schedule(dynamic, 1)
    for (std::int64_t c = 0; c < static_cast<std::int64_t>(chunks); ++c) guarded(static_cast<std::size_t>(c), calling);
  }
  if (first_exception) std::rethrow_exception(first_exception);
#else
  for (std::size_t c = 0; c < chunks; ++c) {
    run(c);
    if (stop(static_cast<double>(c + 1) / static_cast<double>(chunks))) return;
  }
#endif
}

template<class F>
void parallel_for(std::size_t n, F&& f, std::size_t chunk = 1024) {
  parallel_for(n, f, chunk, [](double) { return false; });
}

/// Calls f(x) for every x of a range that can only be walked, such as the elements of any mesh.
/// Needs:  calls with different x do not write to the same place; the range can be walked more than once and by several threads.
/// Result: as of the plain loop, for any number of threads.      Cost: n calls; built with -fopenmp one walk before, which notes where the
///         chunks begin.                                         Errors: what f throws; of several, as parallel_for.
template<class R, class F>
void parallel_for_each(const R& range, F&& f, [[maybe_unused]] std::size_t chunk = 1024) {
  const auto end = range.end();
#ifdef _OPENMP
  if (chunk == 0) chunk = 1;
  std::size_t few = 0;
  auto rest = range.begin();
  for (; few < chunk && rest != end; ++rest) ++few;
  if (rest != end) {
    std::vector<decltype(range.begin())> starts;
    std::size_t n = 0;
    for (auto it = range.begin(); it != end; ++it, ++n)
      if (n % chunk == 0) starts.push_back(it);
    parallel_for(
        starts.size(),
        [&](std::size_t c) {
          auto it = starts[c];
          for (std::size_t k = 0; k < chunk && it != end; ++k, ++it) f(*it);
        },
        1);
    return;
  }
#endif
  for (auto it = range.begin(); it != end; ++it) f(*it);
}

}  // namespace concino
