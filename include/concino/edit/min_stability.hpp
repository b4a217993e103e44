// An invariant that keeps the virtual elements of a mesh stable. Not part of <concino/edit.hpp>: without
// concino::compiled it includes the eigenvalues of Eigen, which take long to compile.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/edit/proposed_edit.hpp>

namespace concino {

/// Refuses edits that make a poly whose stability is less than `limit`.
struct min_stability {
  double limit;

  /// Needs:  a ratio, mostly between 0 and 1. It is the smallest over the largest eigenvalue of the matrix that
  ///         `stiffness` computes of a poly by virtual elements, without the constants. That of the regular polygon of
  ///         as many verts, or of the cube, counts as 1. See stability(m, p) of <concino/operators/stability.hpp>,
  ///         which has the values of the hexagon and the cube. Polys without area or volume have 0.
  /// Result: an invariant for `keep`.
  /// Cost:   O(n^3) for each new poly of n verts, at each edit.
  /// Errors: none.
  explicit constexpr min_stability(double ratio) : limit(ratio) {}
  permission operator()(const proposed_edit& e) const;
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/edit/detail/min_stability.ipp>
#endif
