// Parallel loops over the polys of any mesh. The range of polys need only be iterable: one pass before the loop stores
// where each chunk begins, and how many corners precede it.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/parallel.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace concino::core {

/// The polys of a mesh in chunks that are consecutive in the order of iteration. The mesh must not change while this is
/// used.
template<AnyMesh M>
class poly_chunks {
  static constexpr std::size_t chunk = 1024;
  using range = decltype(polys(std::declval<const M&>()));
  struct start {
    decltype(std::declval<const range&>().begin()) first;
    std::size_t corner;
  };

  range range_;  // stored, since iterators must not outlive their range
  std::vector<start> starts_;
  std::size_t corners_ = 0;

  template<class Visit>
  void visit_chunk(std::size_t c, const Visit& visit) const {
    std::size_t left = chunk;
    for (auto it = starts_[c].first; left > 0 && it != range_.end(); ++it, --left) {
      const poly_t<M> p = *it;
      visit(p);
    }
  }

 public:
  /// Iterates over the polys once, in one thread. visit(p) returns the number of corners of p.
  template<class Visit>
  poly_chunks(const M& m, Visit&& visit) : range_(polys(m)) {
    std::size_t n = 0;
    for (auto it = range_.begin(); it != range_.end(); ++it, ++n) {
      if (n % chunk == 0) starts_.push_back({it, corners_});
      const poly_t<M> p = *it;
      corners_ += static_cast<std::size_t>(visit(p));
    }
  }
  explicit poly_chunks(const M& m) : poly_chunks(m, [](const poly_t<M>&) { return 0; }) {}
  poly_chunks(const poly_chunks&) = delete;
  poly_chunks& operator=(const poly_chunks&) = delete;

  std::size_t num_corners() const { return corners_; }

  /// Calls f(scratch, p, corner) for every poly. `corner` is the number of corners of the polys before it; f returns
  /// the number of its own (any number if that is not used). Chunks run in parallel, each with its own Scratch.
  template<class Scratch, class F>
  void for_each(F&& f) const {
    parallel_for(
        starts_.size(),
        [&](std::size_t c) {
          Scratch scratch;
          std::size_t corner = starts_[c].corner;
          visit_chunk(c, [&](const poly_t<M>& p) { corner += static_cast<std::size_t>(f(scratch, p, corner)); });
        },
        1);
  }

  /// Calls f(result, p) for every poly, with a Result for each chunk, in parallel. Returns these in the order of the
  /// chunks, which do not depend on the number of threads.
  template<class Result, class F>
  std::vector<Result> results(F&& f) const {
    std::vector<Result> all(starts_.size());
    parallel_for(
        starts_.size(),
        [&](std::size_t c) {
          Result result;  // not beside those of other threads
          visit_chunk(c, [&](const poly_t<M>& p) { f(result, p); });
          all[c] = std::move(result);
        },
        1);
    return all;
  }
};

}  // namespace concino::core
