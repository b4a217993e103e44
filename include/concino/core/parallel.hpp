// Parallel loops; all loops in parallel use this header. A loop starts on the calling thread; after a fifth of a
// millisecond it shares the rest with other threads, so that short loops have no overhead. Loops in loops that are
// shared run on one thread each. If the calls write to different places, the result is the same for any number of
// threads. The environment variable CONCINO_NUM_THREADS is the maximum number of threads of a loop, 1 for the calling
// one only. The default is the number of cores available to the process.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/function_ref.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

namespace core {

/// The maximum number of threads of a loop.
std::size_t num_threads();

/// Calls run(first, last) for indices 0 to n in chunks, in several threads if it takes long; calls stop(fraction done),
/// if there is one, as parallel_for does.
void run_chunks(std::size_t n, std::size_t chunk, function_ref<void(std::size_t, std::size_t)> run,
                function_ref<bool(double)> stop);

/// Calls run(c) for every c in [0, chunks), in several threads from the start: for chunks that each take longer than it
/// takes to start a thread.
void for_each_chunk(std::size_t chunks, function_ref<void(std::size_t)> run);

/// Calls run(0) on this thread and run(1) on another, at the same time, whatever the number of threads of a loop. For
/// tests.
/// Errors: what run throws; of both, that of run(0). std::system_error if the system permits no further thread.
void run_twice_at_once(function_ref<void(std::size_t)> run);

/// The type of the callable in a loop: a copy of f if that is equivalent, since compilers then keep the members of f in
/// registers.
template<class F, class Argument>
using loop_body = std::conditional_t<std::is_trivially_copyable_v<F> && std::is_invocable_v<const F&, Argument> &&
                                         sizeof(F) <= 16 * sizeof(void*),
                                     const F, F&>;

/// A range whose parts are accessible without iteration, such as the elements of the native meshes.
template<class R> concept is_divisible = requires(const R& r, std::size_t i) { r.part(i, i); r.index_bound(); };

/// A range in chunks that several threads can visit. The range must live as long.
template<class R>
class range_chunks {
  const R& range_;
  std::size_t chunk_, size_ = 0;
  // of the chunks but the first, unless the range is divisible
  std::vector<decltype(std::declval<const R&>().begin())> later_begins_;

 public:
  range_chunks(const R& range, std::size_t chunk) : range_(range), chunk_(chunk == 0 ? 1 : chunk) {
    if constexpr (is_divisible<R>) {
      size_ = range.index_bound() / chunk_ + (range.index_bound() % chunk_ != 0);
    } else {
      if (num_threads() == 1) {  // no second thread needs to find a chunk
        chunk_ = static_cast<std::size_t>(-1);
        size_ = 1;
        return;
      }
      const auto end = range.end();
      std::size_t n = 0;
      for (auto it = range.begin(); it != end; ++it, ++n)
        if (n > 0 && n % chunk_ == 0) later_begins_.push_back(it);
      size_ = n == 0 ? 0 : later_begins_.size() + 1;
    }
  }
  /// How many chunks there are.
  std::size_t size() const { return size_; }

  /// Calls f(x) for every element of a chunk.
  template<class F>
  void for_each(std::size_t c, F&& f) const {
    if constexpr (is_divisible<R>) {
      const std::size_t first = c * chunk_, left = range_.index_bound() - first;
      for (const auto& x : range_.part(first, first + (left < chunk_ ? left : chunk_))) f(x);
    } else {
      const auto end = range_.end();
      std::size_t n = 0;
      for (auto it = c == 0 ? range_.begin() : later_begins_[c - 1]; n < chunk_ && it != end; ++it, ++n) f(*it);
    }
  }
};

}  // namespace core

/// Calls f(i) for every i in [0, n).
/// Needs:  calls with different i do not write to the same place; chunk > 0 neighbouring indices go to one thread
///         together.
/// Result: as of the plain loop, for any number of threads. `stop` is called now and then on the calling thread; once
///         it returns true the calls not yet begun are omitted.                    Cost: n calls; two locks per chunk.
/// Errors: what f throws; of several exceptions the one of the lowest chunk, as the plain loop would.
template<class F>
void parallel_for(std::size_t n, F&& f, std::size_t chunk, function_ref<bool(double)> stop) {
  const auto run = [&](std::size_t first, std::size_t last) {
    core::loop_body<std::remove_reference_t<F>, std::size_t> body = f;
    for (std::size_t i = first; i < last; ++i) body(i);
  };
  core::run_chunks(n, chunk, run, stop);
}

template<class F>
void parallel_for(std::size_t n, F&& f, std::size_t chunk = 1024) {
  parallel_for(n, f, chunk, {});
}

/// Calls f(x) for every x of a range that can only be iterated over, such as the elements of any mesh.
/// Needs:  calls with different x do not write to the same place; several threads can iterate over the range, more than
///         once.
/// Result: as of the plain loop, for any number of threads.      Cost: n calls; two locks per chunk, and one more
///         iteration, none of a range with accessible parts, as those of the native meshes.
/// Errors: what f throws; of several, as parallel_for.
template<class R, class F>
void parallel_for_each(const R& range, F&& f, std::size_t chunk = 1024) {
  const core::range_chunks<R> chunks(range, chunk);
  const auto run = [&](std::size_t c, std::size_t) {
    core::loop_body<std::remove_reference_t<F>, decltype(*range.begin())> body = f;
    chunks.for_each(c, body);
  };
  core::run_chunks(chunks.size(), 1, run, {});
}

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/core/detail/parallel.ipp>
#endif
