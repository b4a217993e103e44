// Bodies of invariants.hpp: invariants that do not depend on the mesh: no inverted or degenerate poly, a minimum
// quality.
#pragma once

#include <concino/core/local_points.hpp>
#include <concino/edit/detail/proposed_mesh.hpp>
#include <concino/edit/invariants.hpp>
#include <concino/geometry/orientation.hpp>
#include <concino/quality/poly_quality.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace concino {

namespace detail {

inline double largest_coordinate(const vec3& u) { return std::max({std::abs(u.x), std::abs(u.y), std::abs(u.z)}); }

/// The corners of a poly. If their products would overflow or underflow, they are scaled by a power of two, on which
/// neither signs nor qualities depend.
inline std::array<vec3, 4> points_of(const proposed_edit& e, std::span<const unsigned> poly,
                                     std::span<const vec3> points) {
  std::array<vec3, 4> p{};
  double largest = 0;
  for (unsigned i = 0; i < e.corners_per_poly; ++i) {
    p[i] = points[poly[i]];
    largest = std::max(largest, largest_coordinate(p[i]));
  }
  if (largest > 0x1p-200 && largest < 0x1p200) return p;
  int exponent = 0;
  std::frexp(largest, &exponent);
  const double scale = std::ldexp(1.0, std::clamp(-exponent, -1000, 1000));
  for (vec3& x : p) x *= scale;
  return p;
}

/// A vector along the normal, of a length that neither overflows nor underflows; zero for one point.
inline vec3 scaled_normal(const std::array<vec3, 4>& p) {
  vec3 u = p[1] - p[0], v = p[2] - p[0];
  const double lu = largest_coordinate(u), lv = largest_coordinate(v);
  if (lu == 0 || lv == 0) return {};
  return cross(u /= lu, v /= lv);
}

/// The points of some verts, relative to the first of them and scaled. Degenerate: all are one, or one is not finite.
inline std::vector<vec3> fitted_points(std::span<const unsigned> verts, std::span<const vec3> points,
                                       core::local_accuracy& accuracy, bool& is_degenerate) {
  std::vector<vec3> x;
  for (const unsigned v : verts) x.push_back(points[v]);
  is_degenerate = !accuracy.fit(x);
  return x;
}

/// The vector area of a polygon, scaled; 0 if it has none within the accuracy of its coordinates.
inline vec3 polygon_normal(std::span<const unsigned> verts, std::span<const vec3> points) {
  core::local_accuracy accuracy;
  bool is_degenerate = false;
  const auto x = fitted_points(verts, points, accuracy, is_degenerate);
  vec3 area;
  for (std::size_t i = 0; i < x.size() && !is_degenerate; ++i)
    area += 0.5 * cross(x[i], x[i + 1 < x.size() ? i + 1 : 0]);
  return is_degenerate || accuracy.is_zero_area(area, x.size()) ? vec3{} : area;
}

/// Whether new polyhedron k has a positive volume, up to rounding.
inline bool has_positive_volume(const proposed_edit& e, std::size_t k) {
  core::local_accuracy accuracy;
  bool is_degenerate = false;
  const auto corners = e.new_poly(k);
  const auto x = fitted_points(corners, e.points_after, accuracy, is_degenerate);
  if (is_degenerate) return false;
  double volume = 0;
  const proposed_lists faces = e.new_lists(k);
  for (std::size_t i = 0, first = 0; i < faces.size(); first += faces[i].size(), ++i) {
    const std::size_t n = faces[i].size();
    vec3 mean;
    for (std::size_t j = 0; j < n; ++j) mean += x[first + j] / static_cast<double>(n);
    for (std::size_t j = 0; j < n; ++j)
      volume += dot(mean, cross(x[first + j], x[first + (j + 1 < n ? j + 1 : 0)])) / 6;
  }
  const double error = norm(accuracy.error) * accuracy.size * accuracy.size * static_cast<double>(x.size());
  return volume > error;
}

inline bool is_inverted_poly(const proposed_edit& e, std::size_t k) {
  if (e.dimension == 3) return !has_positive_volume(e, k);
  const vec3 normal = polygon_normal(e.new_poly(k), e.points_after);
  if (normal == vec3{}) return true;
  for (unsigned i = e.origins[k].first; i < e.origins[k].first + e.origins[k].count; ++i) {
    const vec3 old = polygon_normal(e.old_poly(i), e.points_before);
    if (!(old == vec3{}) && dot(normal, old) <= 0) return true;
  }
  return false;
}

inline double quality_of_new(const proposed_edit& e, std::size_t k, metric what) {
  if (e.dimension == 3) return quality(new_polyhedron(e, k), poly_id{0}, what);
  return quality(new_polygon(e, k), poly_id{0}, what);
}

}  // namespace detail

CONCINO_INLINE permission no_inversion_invariant::operator()(const proposed_edit& e) const {
  constexpr permission degenerate{refusal::invariant, "no_inversion: a new poly would be degenerate or inverted"};
  for (std::size_t k = 0; e.corners_per_poly == 0 && k < e.num_new_polys(); ++k)
    if (detail::is_inverted_poly(e, k)) return degenerate;
  if (e.corners_per_poly == 0) return {};
  for (std::size_t k = 0; k < e.num_new_polys(); ++k) {
    const auto p = detail::points_of(e, e.new_poly(k), e.points_after);
    if (core::is_degenerate_simplex(std::span(p).first(e.corners_per_poly))) return degenerate;
    if (e.corners_per_poly == 4) {
      if (orient3d(p[0], p[1], p[2], p[3]) <= 0) return degenerate;
      continue;
    }
    const vec3 normal = detail::scaled_normal(p);
    for (unsigned i = e.origins[k].first; i < e.origins[k].first + e.origins[k].count; ++i) {
      const auto old = detail::points_of(e, e.old_poly(i), e.points_before);
      if (!core::is_degenerate_simplex(std::span(old).first(3)) && dot(normal, detail::scaled_normal(old)) <= 0)
        return degenerate;
    }
  }
  return {};
}

CONCINO_INLINE permission min_quality::operator()(const proposed_edit& e) const {
  constexpr permission low_quality{refusal::invariant,
                                   "min_quality: a new poly would have less than the minimum quality"};
  for (std::size_t k = 0; k < e.num_new_polys(); ++k) {
    if (e.corners_per_poly == 0) {
      const double value = detail::quality_of_new(e, k, what);
      if (std::isnan(value) || is_worse(what, value, limit)) return low_quality;
      continue;
    }
    const auto p = detail::points_of(e, e.new_poly(k), e.points_after);
    const bool is_tet = e.corners_per_poly == 4;
    const double value =
        quality(is_tet ? poly_shape::tet : poly_shape::triangle, std::span(p).first(e.corners_per_poly), what);
    if (std::isnan(value) || is_worse(what, value, limit)) return low_quality;
  }
  return {};
}

}  // namespace concino
