// Small curve skeletons for tests.
#pragma once

#include <concino/io/skeleton_graph.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace concino::testing {

inline skeleton skeleton_of_pairs(std::vector<vec3> points, const std::vector<std::array<std::uint32_t, 2>>& pairs, std::vector<double> radii = {}) {
  std::vector<std::array<vert_id, 2>> edges;
  for (const auto& [a, b] : pairs) edges.push_back({vert_id{a}, vert_id{b}});
  return skeleton(std::move(points), std::move(edges), std::move(radii));
}

/// A joint at the origin, and three bones of two edges and length 3.
inline skeleton y_skeleton() {
  return skeleton_of_pairs({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {0, 1, 0}, {0, 3, 0}, {0, 0, 2}, {0, 0, 3}}, {{0, 1}, {1, 2}, {0, 3}, {3, 4}, {0, 5}, {5, 6}},
                           {0.4, 0.3, 0.1, 0.3, 0.2, 0.3, 0.2});
}

/// A regular polygon of n edges in a circle of radius 2.
inline skeleton cycle_skeleton(std::uint32_t n) {
  std::vector<vec3> points;
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double a = 2 * std::numbers::pi * i / n;
    points.push_back({2 * std::cos(a), 2 * std::sin(a), 0.3 * std::sin(2 * a)});
    pairs.push_back({i, (i + 1) % n});
  }
  return skeleton_of_pairs(points, pairs, std::vector<double>(n, 0.3));
}

/// Two joints with three bones between them, one of which is an edge, a cycle at one of the joints, and a vert without edges.
inline skeleton theta_skeleton() {
  return skeleton_of_pairs({{0, 0, 0}, {4, 0, 0}, {2, 2, 0}, {2, -2, 0}, {6, 1, 1}, {6, -1, -1}, {0, 0, 9}},
                           {{0, 1}, {0, 2}, {2, 1}, {1, 3}, {3, 0}, {1, 4}, {4, 5}, {5, 1}}, std::vector<double>(7, 0.25));
}

}  // namespace concino::testing
