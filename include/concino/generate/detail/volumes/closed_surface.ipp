// Bodies of closed_surface.hpp: the surface that tetrahedralize() fills: as flat arrays, checked, oriented and cut into
// triangles.
#pragma once

#include <concino/core/error.hpp>
#include <concino/generate/detail/volumes/closed_surface.hpp>
#include <concino/geometry/orientation.hpp>
#include <concino/geometry/self_intersections.hpp>
#include <concino/geometry/triangulate_polygon.hpp>
#include <concino/mesh/trimesh.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace concino::detail {

/// Whether three points lie on one line, exactly.
inline bool are_collinear(const vec3& a, const vec3& b, const vec3& c) {
  const auto turned = [](const vec3& p) { return vec3{p.y, p.z, p.x}; };
  const vec3 a1 = turned(a), b1 = turned(b), c1 = turned(c);
  return orient2d(a, b, c) == 0 && orient2d(a1, b1, c1) == 0 && orient2d(turned(a1), turned(b1), turned(c1)) == 0;
}

/// What point i is called in messages.
inline std::string point_name(const polygon_arrays& s, std::size_t i) {
  return i < s.vert_index.size() ? core::joined({"vert ", s.vert_index[i]})
                                 : core::joined({"extra point ", i - s.vert_index.size()});
}
inline std::string triangle_name(const polygon_arrays& s, const closed_surface& c, std::size_t t) {
  return t < c.input.surface_triangles ? core::joined({"poly ", s.poly_index[c.poly_of_triangle[t]]})
                                       : core::joined({"facet ", t - c.input.surface_triangles});
}

inline void check_points(const polygon_arrays& s, const std::vector<vec3>& points) {
  std::vector<std::uint32_t> order(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    order[i] = i;
    if (!is_finite(points[i]))
      core::throw_joined<invalid_mesh>({"tetrahedralize: ", point_name(s, i), " is not finite"});
  }
  const auto key = [&](std::uint32_t i) { return std::array<double, 3>{points[i].x, points[i].y, points[i].z}; };
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) { return key(i) < key(j); });
  for (std::size_t k = 1; k < order.size(); ++k)
    if (key(order[k - 1]) == key(order[k])) {
      const auto [i, j] = std::minmax(order[k - 1], order[k]);
      core::throw_joined<invalid_mesh>({"tetrahedralize: ", point_name(s, i), " and ", point_name(s, j),
                                        " are at the same point; merge_verts() joins verts"});
    }
}

/// Cuts the polys into triangles and lists those that are not planar: a corner is off their plane by more than single
/// precision explains.
inline void cut_into_triangles(const polygon_arrays& s, closed_surface& c) {
  polygon_triangulator cut;
  std::vector<vec3> polygon;
  for (std::uint32_t p = 0; p < s.num_polys(); ++p) {
    const std::size_t begin = s.offsets[p], n = s.offsets[p + 1] - begin;
    polygon.clear();
    vec3 area, low = s.points[s.corners[begin]], high = low;
    for (std::size_t i = 0; i < n; ++i) {
      polygon.push_back(s.points[s.corners[begin + i]]);
      for (std::size_t k = 0; k < 3; ++k)
        low[k] = std::min(low[k], polygon[i][k]), high[k] = std::max(high[k], polygon[i][k]);
      if (i >= 2) area += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    }
    const double off = 1e-6 * norm(high - low) * norm(area);
    if (std::any_of(polygon.begin(), polygon.end(),
                    [&](const vec3& q) { return std::abs(dot(q - polygon[0], area)) > off; }))
      c.not_planar.push_back(s.poly_index[p]);
    for (const polygon_triangle& t : cut(polygon)) {
      if (are_collinear(polygon[t[0]], polygon[t[1]], polygon[t[2]]))
        core::throw_joined<invalid_mesh>(
            {"tetrahedralize: poly ", s.poly_index[p],
             n == 3 ? " has no area" : " cannot be cut into triangles that all have an area"});
      c.input.triangles.push_back({s.corners[begin + t[0]], s.corners[begin + t[1]], s.corners[begin + t[2]]});
      c.poly_of_triangle.push_back(p);
    }
  }
  c.input.surface_triangles = c.input.triangles.size();
}

inline void check_not_flat(const closed_surface& c) {
  const auto& t = c.input.triangles.front();
  const std::vector<vec3>& q = c.input.points;
  for (std::size_t i = 0; i < c.input.surface_triangles; ++i)
    for (const std::uint32_t v : c.input.triangles[i])
      if (orient3d(q[t[0]], q[t[1]], q[t[2]], q[v]) != 0) return;
  throw invalid_mesh("tetrahedralize: the surface is flat: all verts lie in one plane");
}

inline void check_intersections(const polygon_arrays& s, const closed_surface& c) {
  surface_arrays a;
  a.points = c.input.points;
  a.arity = 3;
  for (const auto& t : c.input.triangles)
    for (const std::uint32_t v : t) a.verts.push_back(vert_id{v});
  const auto pairs = self_intersections(trimesh(std::move(a)));
  if (pairs.empty()) return;
  core::throw_joined<invalid_mesh>({"tetrahedralize: ", triangle_name(s, c, pairs[0].first.raw()), " and ",
                                    triangle_name(s, c, pairs[0].second.raw()), " intersect",
                                    pairs.size() == 1 ? "" : core::joined({", and ", pairs.size() - 1, " more pairs"}),
                                    "; self_intersections() lists those of a surface"});
}

inline double diagonal_of(const std::vector<vec3>& points) {
  vec3 low = points.front(), high = low;
  for (const vec3& p : points)
    for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
  return norm(high - low);
}

CONCINO_INLINE closed_surface checked_surface(polygon_arrays s, const tetrahedralize_options& o) {
  if (s.num_polys() == 0) throw invalid_mesh("tetrahedralize: the surface has no polys");
  closed_surface c;
  c.input.points = s.points;
  c.input.points.insert(c.input.points.end(), o.extra_points.begin(), o.extra_points.end());
  check_points(s, c.input.points);
  c.input.diagonal = diagonal_of(c.input.points);
  orient_alike(s);
  cut_into_triangles(s, c);
  check_not_flat(c);
  const std::size_t numbered = s.point_of_vert.size() + o.extra_points.size();
  const auto point_of = [&](const char* what, std::size_t k, std::uint32_t number) {
    if (number >= numbered)
      core::throw_joined<invalid_argument>({"tetrahedralize: ", what, k, " has point ", number, ", but there are ",
                                            numbered, ": the verts and the extra points"});
    if (number >= s.point_of_vert.size())
      return static_cast<std::uint32_t>(s.points.size() + number - s.point_of_vert.size());
    if (s.point_of_vert[number] == s.no_point)
      core::throw_joined<invalid_argument>({"tetrahedralize: ", what, k, " has vert ", number, ", which has no poly"});
    return s.point_of_vert[number];
  };
  const std::vector<vec3>& q = c.input.points;
  for (std::size_t k = 0; k < o.segments.size(); ++k) {
    c.input.segments.push_back({point_of("segment ", k, o.segments[k][0]), point_of("segment ", k, o.segments[k][1])});
    if (c.input.segments[k][0] == c.input.segments[k][1])
      core::throw_joined<invalid_argument>({"tetrahedralize: segment ", k, " joins a point with itself"});
  }
  for (std::size_t k = 0; k < o.facets.size(); ++k) {
    const auto& f = o.facets[k];
    const std::array t{point_of("facet ", k, f[0]), point_of("facet ", k, f[1]), point_of("facet ", k, f[2])};
    if (are_collinear(q[t[0]], q[t[1]], q[t[2]]))
      core::throw_joined<invalid_argument>({"tetrahedralize: facet ", k, " has no area"});
    c.input.triangles.push_back(t);
  }
  check_intersections(s, c);
  for (std::size_t t = 0; t < c.input.surface_triangles; ++t) {
    const auto& corners = c.input.triangles[t];
    c.volume += dot(q[corners[0]] - q[0], cross(q[corners[1]] - q[0], q[corners[2]] - q[0])) / 6;
  }
  return c;
}

}  // namespace concino::detail
