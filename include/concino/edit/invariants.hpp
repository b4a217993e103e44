// Invariants that do not depend on the mesh: no inverted or degenerate poly, a minimum quality.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/edit/proposed_edit.hpp>

namespace concino {

/// See no_inversion.
struct no_inversion_invariant {
  permission operator()(const proposed_edit& e) const;
};

/// Refuses edits that make degenerate or inverted polys. Those are tets whose volume is not positive, by the sign of the exact determinant, triangles without
/// area, and triangles whose normal turns by 90 degrees or more from that of an old triangle that they come from.
/// Needs:  an option `keep` of an edit.      Result: a permission.      Cost: the polys of the edit.      Errors: none.
/// Source: Shewchuk 1997, as orient3d.
inline constexpr no_inversion_invariant no_inversion{};

/// What min_quality compares.
enum class quality_metric : unsigned char {
  mean_ratio,       // see <concino/quality/mean_ratio.hpp>
  scaled_jacobian,  // see <concino/quality/scaled_jacobian.hpp>
};

/// Refuses edits that make a poly whose quality is less than `min_value`.
struct min_quality {
  double min_value;
  quality_metric metric;

  /// Needs:  a quality, at most 1.      Result: an invariant for `keep`.      Cost: the polys of the edit, at each edit.
  /// Errors: none.
  explicit constexpr min_quality(double value, quality_metric measured_by = quality_metric::mean_ratio) : min_value(value), metric(measured_by) {}
  permission operator()(const proposed_edit& e) const;
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/edit/detail/invariants.ipp>
#endif
