// Invariants that do not depend on the mesh: no inverted or degenerate poly, a minimum quality.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/edit/proposed_edit.hpp>
#include <concino/quality/metric.hpp>

namespace concino {

/// See no_inversion.
struct no_inversion_invariant {
  permission operator()(const proposed_edit& e) const;
};

/// Refuses edits that make degenerate or inverted polys. Degenerate are triangles without area and tets without volume,
/// within the accuracy of their coordinates: those that validate reports as of zero size. Inverted are tets whose
/// volume is not positive, by the sign of the exact determinant. So are triangles whose normal turns by 90 degrees or
/// more from that of an old triangle that they come from, and polygons by their vector areas. Polyhedra are degenerate
/// or inverted if their volume is not positive, up to rounding.
/// Needs:  an option `keep` of an edit.      Result: a permission.      Cost: the polys of the edit.      Errors: none.
/// Source: Shewchuk 1997, as orient3d.
inline constexpr no_inversion_invariant no_inversion{};

/// Refuses edits that make a poly whose quality is worse than `limit`.
struct min_quality {
  double limit;
  metric what;

  /// Needs:  a value of a metric that is defined for the shapes of new polys, and that does not depend on other polys
  ///         (see <concino/quality/metric.hpp>). star_shapedness is defined for all shapes.
  /// Result: an invariant for `keep`.      Cost: the polys of the edit, at each edit.
  /// Errors: none; an edit of polys for whose shape the metric is not defined throws unsupported.
  explicit constexpr min_quality(double worst_value, metric measured_by = metric::mean_ratio)
      : limit(worst_value), what(measured_by) {}
  permission operator()(const proposed_edit& e) const;
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/edit/detail/invariants.ipp>
#endif
