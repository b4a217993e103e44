// Criteria for the positions of polys: below and above an axis-aligned plane or any plane.
//
// They compare the centroid of a poly: centroid(m, p). It is computed only for polys that the plane crosses: those
// whose verts all lie on one side are on this side, even if they are turned over, so that their centroid is elsewhere.
// A poly with a coordinate that is not a number meets none of them.
#pragma once

#include <concino/core/error.hpp>
#include <concino/geometry/bounding_box.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/geometry/lines_and_planes.hpp>
#include <concino/render/criterion.hpp>

#include <cmath>
#include <limits>

namespace concino {

namespace detail {

/// Whether the centroid of p has a height in [low, high), where the height is a linear function of a point.
template<class M, class Height>
bool is_centroid_between(const M& m, const poly_t<M>& p, const Height& height, double low, double high) {
  bool is_below = true, is_inside = true, is_above = true;
  for (const vert_t<M> v : adj_p2v(m, p)) {
    const double x = height(to_vec3(point(m, v)));
    is_below = is_below && x < low;
    is_above = is_above && x >= high;
    is_inside = is_inside && low <= x && x < high;
  }
  if (is_below || is_above) return false;
  if (is_inside) return true;
  const double x = height(centroid(m, p));
  return low <= x && x < high;
}

inline constexpr double unlimited = std::numeric_limits<double>::infinity();

}  // namespace detail

/// Polys whose centroid has a coordinate in [low, high).
struct coordinate_criterion : criterion_base {
  std::size_t axis = 0;
  double low = -detail::unlimited, high = detail::unlimited;
  bool are_fractions = false;  // of the bounding box of all verts: 0 at its smaller end, 1 at its larger end

  template<EmbeddedMesh M>
  auto prepare(const M& m) const {
    double from = low, to = high;
    if (are_fractions) {
      const box b = bounding_box(m);
      const auto at = [&](double t) { return std::isinf(t) ? t : (1 - t) * b.min[axis] + t * b.max[axis]; };
      from = at(low), to = at(high);
    }
    return [&m, k = axis, from, to](const poly_t<M>& p) -> bool {
      return detail::is_centroid_between(
          m, p, [k](const vec3& x) { return x[k]; }, from, to);
    };
  }
};

/// Polys whose centroid is on one side of a plane.
struct plane_criterion : criterion_base {
  plane divider;
  bool is_above = true;  // or on the plane; false: below

  template<EmbeddedMesh M>
  auto prepare(const M& m) const {
    const double low = is_above ? divider.offset : -detail::unlimited,
                 high = is_above ? detail::unlimited : divider.offset;
    return [&m, n = divider.normal, low, high](const poly_t<M>& p) -> bool {
      return detail::is_centroid_between(m, p, [n](const vec3& x) { return dot(n, x); }, low, high);
    };
  }
};

namespace detail {

inline coordinate_criterion coordinate_between(const char* caller, char axis, double low, double high,
                                               bool are_fractions) {
  if (axis != 'x' && axis != 'y' && axis != 'z')
    core::throw_joined<invalid_argument>({caller, ": the axis must be 'x', 'y' or 'z'"});
  if (std::isnan(low) || std::isnan(high))
    core::throw_joined<invalid_argument>(
        {caller, are_fractions ? ": the fraction" : ": a coordinate", " is not a number (NaN)"});
  if (low > high) core::throw_joined<invalid_argument>({caller, ": the lower coordinate is above the upper one"});
  return {{}, static_cast<std::size_t>(axis - 'x'), low, high, are_fractions};
}

inline plane_criterion side_of(const char* caller, const plane& p, bool is_above) {
  if (!(norm(p.normal) > 0) || !is_finite(p.normal) || !std::isfinite(p.offset))
    core::throw_joined<invalid_argument>(
        {caller, ": the plane must have a finite offset and a finite normal other than 0"});
  return {{}, p, is_above};
}

}  // namespace detail

/// Polys whose centroid is below a coordinate or a plane, in [low, high) between two coordinates, or at a coordinate or
/// a plane or above it. So each poly is either below or above, and intervals that follow each other have no poly in
/// common.
/// Needs:  axis: 'x', 'y' or 'z'; coordinates in units of the mesh, which may be infinite; a plane with a normal of any
///         length but 0.
/// Result: a criterion for any EmbeddedMesh.
/// Cost:   O(1); to evaluate it, the verts of each poly, and the centroid of those on both sides.
/// Errors: invalid_argument if the axis is none of these, a coordinate is NaN, low > high, or the plane has no normal
///         or is not finite.
inline coordinate_criterion below(char axis, double coordinate) {
  return detail::coordinate_between("below", axis, -detail::unlimited, coordinate, false);
}
inline coordinate_criterion above(char axis, double coordinate) {
  return detail::coordinate_between("above", axis, coordinate, detail::unlimited, false);
}
inline coordinate_criterion between(char axis, double low, double high) {
  return detail::coordinate_between("between", axis, low, high, false);
}
inline plane_criterion below(const plane& p) { return detail::side_of("below", p, false); }
inline plane_criterion above(const plane& p) { return detail::side_of("above", p, true); }

/// The same with a coordinate that is a fraction of the bounding box of the mesh: below_fraction('x', 0.5) is one half
/// of it.
/// Needs:  axis: 'x', 'y' or 'z'; a fraction, 0 to 1 inside the box.
/// Result: a criterion for any EmbeddedMesh.
/// Cost:   as above, and that of the bounding box.
/// Errors: invalid_argument if the axis is none of these, or the fraction is NaN.
inline coordinate_criterion below_fraction(char axis, double fraction) {
  return detail::coordinate_between("below_fraction", axis, -detail::unlimited, fraction, true);
}
inline coordinate_criterion above_fraction(char axis, double fraction) {
  return detail::coordinate_between("above_fraction", axis, fraction, detail::unlimited, true);
}

}  // namespace concino
