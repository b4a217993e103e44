// Measures of drawables, and the check that their polygons form closed surfaces.
#pragma once

#include <concino/render/drawable.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace concino::testing {

inline double area_of(const drawable& d) {
  double sum = 0;
  for (const auto& t : d.triangles) {
    const vec3 a = d.points[d.corners[t[0]]], b = d.points[d.corners[t[1]]], c = d.points[d.corners[t[2]]];
    sum += norm(cross(b - a, c - a)) / 2;
  }
  return sum;
}

/// The edges of the polygons in the direction that these have, sorted.
inline std::vector<std::pair<std::uint32_t, std::uint32_t>> directed_edges(const drawable& d) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t p = 0; p + 1 < d.offsets.size(); ++p)
    for (std::uint32_t i = d.offsets[p]; i < d.offsets[p + 1]; ++i) edges.emplace_back(d.corners[i], d.corners[i + 1 < d.offsets[p + 1] ? i + 1 : d.offsets[p]]);
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Checks that the arrays fit together, and that each edge has two polygons, with opposite directions.
inline void check_closed(const drawable& d) {
  REQUIRE(d.offsets.back() == d.corners.size());
  REQUIRE(d.normals.size() == d.corners.size());
  REQUIRE(d.polys.size() == d.polygons().size());
  REQUIRE(d.polygon_of.size() == d.triangles.size());
  std::size_t elsewhere = 0;
  for (std::size_t t = 0; t < d.triangles.size(); ++t)
    for (const std::uint32_t c : d.triangles[t]) elsewhere += c < d.offsets[d.polygon_of[t]] || c >= d.offsets[d.polygon_of[t] + 1];
  REQUIRE(elsewhere == 0);
  const auto edges = directed_edges(d);
  CHECK(std::adjacent_find(edges.begin(), edges.end()) == edges.end());
  const bool has_partners = std::all_of(edges.begin(), edges.end(), [&](const auto& e) { return std::binary_search(edges.begin(), edges.end(), std::pair(e.second, e.first)); });
  CHECK(has_partners);
}

/// Points - edges + polygons of closed surfaces: 2 for each ball, 0 for each ring.
inline long euler_characteristic(const drawable& d) {
  return static_cast<long>(d.points.size()) - static_cast<long>(directed_edges(d).size() / 2) + static_cast<long>(d.polygons().size());
}

}  // namespace concino::testing
