// The one header that loops in parallel. The chunks of a loop run on all cores; as long as the calls write to different places the result is the same
// for any number of threads. The environment variable CONCINO_NUM_THREADS says how many threads a loop takes, 1 for none beside the calling one; where
// it is not set, as many as the process has cores.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/function_ref.hpp>

#include <cstddef>
#include <vector>

namespace concino {

namespace core {

/// How many threads a loop may take.
std::size_t num_threads();

/// Calls run(c) for every c in [0, chunks), in several threads; then asks stop(fraction done), if there is one. See parallel_for.
void for_each_chunk(std::size_t chunks, function_ref<void(std::size_t)> run, function_ref<bool(double)> stop);

}  // namespace core

/// Calls f(i) for every i in [0, n).
/// Needs:  calls with different i do not write to the same place; chunk > 0 neighbouring indices go to one thread together.
/// Result: as of the plain loop, for any number of threads. `stop` is asked now and then on the calling thread; once it
///         says true the calls not yet begun are left out.                      Cost: n calls, one atomic step per chunk.
/// Errors: what f throws; of several exceptions the one of the lowest chunk, as the plain loop would.
template<class F>
void parallel_for(std::size_t n, F&& f, std::size_t chunk, function_ref<bool(double)> stop) {
  if (chunk == 0) chunk = 1;
  core::for_each_chunk(
      n / chunk + (n % chunk != 0),
      [&](std::size_t c) {
        const std::size_t first = c * chunk, last = n - first < chunk ? n : first + chunk;
        for (std::size_t i = first; i < last; ++i) f(i);
      },
      stop);
}

template<class F>
void parallel_for(std::size_t n, F&& f, std::size_t chunk = 1024) {
  parallel_for(n, f, chunk, {});
}

/// Calls f(x) for every x of a range that can only be walked, such as the elements of any mesh.
/// Needs:  calls with different x do not write to the same place; the range can be walked more than once and by several threads.
/// Result: as of the plain loop, for any number of threads.      Cost: n calls; one walk before, which notes where the chunks begin, unless one thread is
///         enough.                                               Errors: what f throws; of several, as parallel_for.
template<class R, class F>
void parallel_for_each(const R& range, F&& f, std::size_t chunk = 1024) {
  const auto end = range.end();
  if (chunk == 0) chunk = 1;
  std::size_t few = 0;
  auto rest = range.begin();
  for (; few < chunk && rest != end; ++rest) ++few;
  if (rest != end && core::num_threads() > 1) {
    std::vector<decltype(range.begin())> starts;
    std::size_t n = 0;
    for (auto it = range.begin(); it != end; ++it, ++n)
      if (n % chunk == 0) starts.push_back(it);
    core::for_each_chunk(
        starts.size(),
        [&](std::size_t c) {
          auto it = starts[c];
          for (std::size_t k = 0; k < chunk && it != end; ++k, ++it) f(*it);
        },
        {});
    return;
  }
  for (auto it = range.begin(); it != end; ++it) f(*it);
}

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/core/detail/parallel.ipp>
#endif
