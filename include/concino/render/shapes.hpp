// Small shapes that mark points in a picture.
#pragma once

#include <concino/core/error.hpp>
#include <concino/render/drawable.hpp>

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace concino {

/// Balls of one size and colour, with smooth normals.
/// Needs:  finite centres; radius above 0, in units of the mesh.
/// Result: one drawable with all balls.      Cost: 1,280 triangles each.
/// Errors: invalid_argument if the radius is not positive and finite, or a centre is not finite.
/// Source: an icosahedron whose faces are split into four, three times.
inline drawable make_balls(std::span<const vec3> centers, double radius, const rgb& color) {
  if (!(radius > 0) || !std::isfinite(radius)) throw invalid_argument("make_balls: the radius must be positive");
  const double g = 1.61803398874989484820;
  std::vector<vec3> sphere = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                              {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  std::vector<std::array<std::uint32_t, 3>> triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                                                     {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                                                     {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (vec3& p : sphere) p /= norm(p);
  for (int round = 0; round < 3; ++round) {
    std::unordered_map<std::uint64_t, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [it, added] =
          middles.try_emplace(std::uint64_t{std::min(a, b)} << 32 | std::max(a, b), static_cast<std::uint32_t>(sphere.size()));
      if (added) {
        const vec3 p = sphere[a] + sphere[b];
        sphere.push_back(p / norm(p));
      }
      return it->second;
    };
    std::vector<std::array<std::uint32_t, 3>> finer;
    for (const auto& [a, b, c] : triangles) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    triangles.swap(finer);
  }

  drawable d;
  d.look.color = color;
  for (const vec3& center : centers) {
    if (!is_finite(center)) throw invalid_argument("make_balls: a centre has a coordinate that is not a finite number");
    const std::uint32_t base = static_cast<std::uint32_t>(d.points.size());
    for (const vec3& p : sphere) d.points.push_back(center + p * radius);
    for (const auto& f : triangles) {
      for (const std::uint32_t i : f) {
        d.corners.push_back(base + i);
        d.normals.push_back(detail::to_normal3(sphere[i]));
      }
      d.offsets.push_back(static_cast<std::uint32_t>(d.corners.size()));
      d.polys.push_back(base);
    }
  }
  detail::add_triangles(d);
  return d;
}

}  // namespace concino
