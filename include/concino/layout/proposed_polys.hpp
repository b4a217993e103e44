// proposed_polys: the quads or hexes that an edit of a chord or sheet would change or make, for conditions on their
// shapes. min_poly_quality is one.
//
//   cn::collapse_sheet(m, s, {.keep = cn::min_poly_quality(0.1)});
#pragma once

#include <concino/core/function_ref.hpp>
#include <concino/edit/permission.hpp>
#include <concino/quality/metric.hpp>

#include <span>

namespace concino {

/// Quads or hexes by the points of their corners, in the order of adj_p2v, one poly after another.
struct proposed_polys {
  poly_shape shape = poly_shape::quad;
  std::span<const vec3> points;

  std::size_t corners_per_poly() const { return shape == poly_shape::quad ? 4 : 8; }
  std::size_t num_polys() const { return points.size() / corners_per_poly(); }
  std::span<const vec3> poly(std::size_t k) const { return points.subspan(k * corners_per_poly(), corners_per_poly()); }
};

/// Whether an edit that leads to these polys is allowed. It is asked before anything changes.
using shape_condition = function_ref<permission(const proposed_polys&)>;

/// Refuses edits that make a poly whose quality is worse than `limit`.
struct min_poly_quality {
  double limit;
  metric what;

  /// Needs:  a value of a metric that does not depend on other polys (see <concino/quality/metric.hpp>).
  /// Result: a condition for `keep`.      Cost: the polys of the edit.
  /// Errors: none; an edit of polys for whose shape the metric is not defined throws unsupported.
  explicit constexpr min_poly_quality(double worst_value, metric measured_by = metric::scaled_jacobian)
      : limit(worst_value), what(measured_by) {}
  permission operator()(const proposed_polys& e) const {
    for (std::size_t k = 0; k < e.num_polys(); ++k)
      if (const double q = quality(e.shape, e.poly(k), what); q != q || is_worse(what, q, limit))
        return {refusal::invariant, "min_poly_quality: a poly would have less than the minimum quality"};
    return {};
  }
};

}  // namespace concino
