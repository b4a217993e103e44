// Defines medial_balls.hpp.
#pragma once

#include <concino/geometry/bounding_tree.hpp>
#include <concino/mesh/trimesh.hpp>
#include <concino/skeleton/detail/medial_balls.hpp>

#include <cstddef>

namespace concino::detail {

CONCINO_INLINE std::vector<medial_ball> medial_balls(const std::vector<vec3>& points,
                                                     const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  std::vector<medial_ball> balls(points.size());
  std::vector<vec3> normals(points.size());
  surface_arrays arrays{points, {}, {}, 3};
  double volume = 0;
  for (const auto& [a, b, c] : triangles) {
    const vec3 twice = cross(points[b] - points[a], points[c] - points[a]);
    for (const std::uint32_t v : {a, b, c}) {
      normals[v] += twice;
      arrays.verts.push_back(vert_id{v});
    }
    volume += dot(twice, points[a] - points[0]);
  }
  const trimesh m(std::move(arrays));
  const auto tree = bounding_tree(m);
  for (std::size_t v = 0; v < points.size(); ++v) {
    const double length = norm(normals[v]);
    if (!(length > 0)) continue;
    const vec3 x = points[v], inward = (volume < 0 ? 1 : -1) / length * normals[v];
    constexpr double at_vert = 1e-9;  // points have a size near 1
    double radius = 0;
    for (const auto& hit : tree.ray_all(x, inward))
      if (hit.parameter > at_vert) {
        radius = hit.parameter / 2;
        break;
      }
    for (int i = 0; i < 30 && radius > 0; ++i) {
      // A smaller ball is tested: the centre of a large one may have the same distance from the whole surface.
      const vec3 to_x = x - tree.closest(x + 0.9 * radius * inward).point;
      const double distance = norm(to_x), depth = -dot(to_x, inward);
      // The triangles at a convex vert are in all balls that touch it, so that what is at a small angle is ignored.
      constexpr double smallest_sine = 0.75;
      if (!(distance > at_vert) || depth < smallest_sine * distance) break;
      const double next = distance * distance / (2 * depth);
      if (!(next < 0.9 * radius)) break;
      radius = next;
    }
    balls[v] = {x + radius * inward, radius};
  }
  return balls;
}

}  // namespace concino::detail
