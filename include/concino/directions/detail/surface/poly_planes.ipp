// Bodies of poly_planes.hpp: polys, projected along the vectors of their areas.
#pragma once

#include <concino/directions/detail/surface/poly_planes.hpp>

#include <cmath>
#include <numbers>

namespace concino::detail {

CONCINO_INLINE poly_planes::poly_planes(const oriented_surface& s)
    : axes(s.num_polys()), along(s.vert.size()), inside(s.vert.size()) {
  for (std::size_t p = 0; p < s.num_polys(); ++p) {
    const vec3 area = s.vector_area(p), n = area / norm(area);
    vec3 u;
    for (std::uint32_t c = s.first[p]; c < s.first[p + 1]; ++c) {
      const vec3 x = s.points[s.vert[s.next[c]]] - s.points[s.vert[c]], flat = x - dot(x, n) * n;
      if (norm(flat) > norm(u)) u = flat;
    }
    u = u / norm(u);
    axes[p] = {u, cross(n, u)};
    const auto angle_of = [&](std::uint32_t a, std::uint32_t b) {
      const vec3 x = s.points[s.vert[b]] - s.points[s.vert[a]];
      return std::atan2(dot(x, axes[p][1]), dot(x, u));
    };
    for (std::uint32_t c = s.first[p]; c < s.first[p + 1]; ++c) {
      along[c] = angle_of(c, s.next[c]);
      inside[c] = angle_of(c, s.previous[c]) - along[c];
      if (inside[c] < 0) inside[c] += 2 * std::numbers::pi;
    }
  }
}

}  // namespace concino::detail
