// Cuts a convex part of a triangle, with corners along its edges, into triangles none of which is flat.
#pragma once

#include <concino/core/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// A corner of the part. on_edges: a bit for each edge of the triangle on which it is, so that it does not depend on
/// rounding whether a triangle is flat.
struct part_corner {
  std::uint32_t number;
  unsigned char on_edges;
  vec3 position;
};

/// Calls f(numbers) for each triangle. Of the triangles that can be cut off, the one of the best shape comes next.
/// Changes the corners.
/// Needs: three corners or more, not all on one edge.
template<class F>
void triangulate_part(std::vector<part_corner>& corners, const F& f) {
  const auto shape = [](const vec3& a, const vec3& b, const vec3& c) {
    const vec3 x = b - a, y = c - b, z = a - c;
    const double size = dot(x, x) + dot(y, y) + dot(z, z);
    return size > 0 ? norm(cross(x, y)) / size : 0;
  };
  while (corners.size() > 3) {
    const std::size_t n = corners.size();
    std::size_t best = n;
    double best_shape = -1;
    for (std::size_t i = 0; i < n; ++i) {
      const part_corner &before = corners[(i + n - 1) % n], &corner = corners[i], &after = corners[(i + 1) % n];
      if (before.on_edges & corner.on_edges & after.on_edges) continue;
      unsigned char others = 0xff;
      for (std::size_t k = 0; k < n; ++k)
        if (k != i) others &= corners[k].on_edges;
      if (others != 0) continue;  // the rest would be a line
      const double s = shape(before.position, corner.position, after.position);
      if (!(s > best_shape) && best < n) continue;
      best = i;
      best_shape = s;
    }
    f(std::array{corners[(best + n - 1) % n].number, corners[best].number, corners[(best + 1) % n].number});
    corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(best));
  }
  f(std::array{corners[0].number, corners[1].number, corners[2].number});
}

}  // namespace concino::detail
