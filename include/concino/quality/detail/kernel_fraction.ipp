// Defines kernel_fraction.hpp: a convex polygon or polyhedron, first the bounding box, is cut by the lines or planes of
// all facets.
#pragma once

#include <concino/geometry/support/convex_cuts.hpp>
#include <concino/quality/detail/kernel_fraction.hpp>
#include <concino/quality/detail/metric_row.hpp>

#include <cmath>
#include <vector>

namespace concino::detail {

CONCINO_INLINE double kernel_fraction_of_polygon(std::span<const vec3> points, const vec3& area) {
  const double size = norm(area);
  if (!(size > 0)) return 0;
  const vec3 n = area / size;
  vec3 e = std::abs(n.x) < 0.6 ? vec3{1, 0, 0} : vec3{0, 1, 0};
  e -= dot(e, n) * n;
  e /= norm(e);
  const vec3 f = cross(n, e);
  std::vector<vec3> flat;
  for (const vec3& p : points) flat.push_back({dot(p - points[0], e), dot(p - points[0], f), 0});
  const core::flat_kernel kernel = core::kernel_of(flat);
  return kernel.is_whole ? 1 : std::clamp(core::flat_area(kernel.corners) / size, 0.0, 1.0);
}

/// Calls f(n, x) for the planes of all facets of a polyhedron, as core::for_each_face_plane.
template<class F>
void for_each_facet_plane(const poly_geometry& g, double eps, const F& f) {
  for (std::size_t k = 0; k + 1 < g.face_begins.size(); ++k) {
    const auto face = g.face_verts.subspan(g.face_begins[k], g.face_begins[k + 1] - g.face_begins[k]);
    core::for_each_face_plane(
        face.size(), [&](std::size_t i) -> const vec3& { return g.points[face[i]]; }, eps, f);
  }
}

CONCINO_INLINE double kernel_fraction_of_polyhedron(const poly_geometry& g, double volume) {
  if (!(volume > 0)) return 0;
  vec3 low = g.points[0], high = low;
  for (const vec3& x : g.points)
    for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], x[k]), high[k] = std::max(high[k], x[k]);
  const double eps = core::flat_part * std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  bool convex = true;
  for_each_facet_plane(g, eps, [&](const vec3& n, const vec3& origin) {
    for (const vec3& x : g.points) convex = convex && dot(n, x - origin) <= 1e3 * eps;
  });
  if (convex) return 1;
  core::convex_body kernel(low, high);
  for_each_facet_plane(g, eps, [&](const vec3& n, const vec3& origin) { kernel.cut(n, origin); });
  return std::clamp(kernel.volume() / volume, 0.0, 1.0);
}

}  // namespace concino::detail
