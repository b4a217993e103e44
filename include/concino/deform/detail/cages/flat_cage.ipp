// Bodies of flat_cage.hpp: a closed cage as triangles: its polys, cut into triangles, with the edges that these share.
#pragma once

#include <concino/deform/detail/cages/flat_cage.hpp>
#include <concino/geometry/triangulate_polygon.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace concino::detail {

CONCINO_INLINE void flat_cage::give_to_corners(std::vector<double>& weights) const {
  for (std::size_t c = 0; c + 1 < centre_first.size(); ++c) {
    const double part = weights[num_verts + c] / static_cast<double>(centre_first[c + 1] - centre_first[c]);
    for (std::uint32_t k = centre_first[c]; k < centre_first[c + 1]; ++k) weights[centre_corners[k]] += part;
  }
}

/// Cuts a poly into triangles around the mean of its corners if none of them is turned, else by diagonals.
CONCINO_INLINE void cut_cage_poly(std::span<const std::uint32_t> poly, polygon_triangulator& triangulate,
                                  flat_cage& flat) {
  const std::size_t n = poly.size();
  if (n == 3) {
    flat.triangles.push_back({poly[0], poly[1], poly[2]});
    return;
  }
  std::vector<vec3> corners;
  vec3 mean, area;
  for (const std::uint32_t v : poly) corners.push_back(flat.points[v]);
  for (const vec3& x : corners) mean += x / static_cast<double>(n);
  for (std::size_t k = 0; k < n; ++k) area += cross(corners[k] - mean, corners[(k + 1) % n] - mean);
  bool sees_all = true;
  for (std::size_t k = 0; k < n; ++k)
    sees_all = sees_all && dot(area, cross(corners[k] - mean, corners[(k + 1) % n] - mean)) >
                               1e-6 * dot(area, area) / static_cast<double>(n);
  if (!sees_all) {
    for (const polygon_triangle& t : triangulate(corners))
      flat.triangles.push_back({poly[t[0]], poly[t[1]], poly[t[2]]});
    return;
  }
  const auto centre = static_cast<std::uint32_t>(flat.points.size());
  flat.points.push_back(mean);
  flat.centre_corners.insert(flat.centre_corners.end(), poly.begin(), poly.end());
  flat.centre_first.push_back(static_cast<std::uint32_t>(flat.centre_corners.size()));
  for (std::size_t k = 0; k < n; ++k) flat.triangles.push_back({poly[k], poly[(k + 1) % n], centre});
}

/// Numbers the edges of the triangles.
/// Errors: invalid_mesh if one is not passed as often in the one direction as in the other.
CONCINO_INLINE void number_cage_edges(flat_cage& flat, const char* caller) {
  struct passed_edge {
    std::array<std::uint32_t, 2> ends;
    std::uint32_t triangle, k;
    bool forward;
  };
  std::vector<passed_edge> all;
  for (std::size_t t = 0; t < flat.triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t a = flat.triangles[t][(k + 1) % 3], b = flat.triangles[t][(k + 2) % 3];
      all.push_back({{std::min(a, b), std::max(a, b)}, static_cast<std::uint32_t>(t), k, a < b});
    }
  std::sort(all.begin(), all.end(), [](const passed_edge& x, const passed_edge& y) {
    return x.ends != y.ends ? x.ends < y.ends : x.triangle < y.triangle;
  });
  flat.triangle_edges.resize(flat.triangles.size());
  for (std::size_t i = 0; i < all.size();) {
    const auto ends = all[i].ends;
    long balance = 0;
    for (; i < all.size() && all[i].ends == ends; ++i) {
      balance += all[i].forward ? 1 : -1;
      flat.triangle_edges[all[i].triangle][all[i].k] = static_cast<std::uint32_t>(flat.edges.size());
    }
    if (balance != 0 && ends[0] != ends[1])
      core::throw_joined<invalid_mesh>({caller, ": the cage is open or not consistently oriented at the edge of verts ",
                                        ends[0], " and ", ends[1],
                                        "; repair(cage, {.orient = true, .fill_holes = 10}) may help"});
    flat.edges.push_back(ends);
  }
}

CONCINO_INLINE flat_cage make_flat_cage(const cage_polys& cage, const char* caller) {
  flat_cage flat;
  if (cage.index.empty()) core::throw_joined<invalid_mesh>({caller, ": the cage has no polys"});
  double largest = 0;
  constexpr double inf = std::numeric_limits<double>::infinity();
  vec3 low{inf, inf, inf}, high{-inf, -inf, -inf};
  for (const std::uint32_t v : cage.corners)
    for (const std::size_t k : {0u, 1u, 2u}) {
      low[k] = std::min(low[k], cage.points[v][k]), high[k] = std::max(high[k], cage.points[v][k]);
      largest = std::max(largest, high[k] - low[k]);
    }
  if (!(largest > 0 && std::isfinite(largest)))
    core::throw_joined<invalid_mesh>({caller, ": the points of the cage are all equal, or too far apart"});
  int exponent = 0;
  std::frexp(largest, &exponent);
  flat.unit = std::ldexp(1.0, exponent);
  if (!(flat.unit > 1e-290 && flat.unit < 1e290))
    core::throw_joined<invalid_mesh>({caller, ": the size of the cage is beyond 1e-290 to 1e290; scale it"});
  flat.size = norm(high / flat.unit - low / flat.unit);
  flat.num_verts = cage.points.size();
  for (const vec3& x : cage.points) flat.points.push_back(x / flat.unit);
  polygon_triangulator triangulate;
  for (std::size_t p = 0; p < cage.index.size(); ++p) cut_cage_poly(cage.poly(p), triangulate, flat);
  for (const auto& t : flat.triangles) {
    const vec3 n = cross(flat.points[t[1]] - flat.points[t[0]], flat.points[t[2]] - flat.points[t[0]]);
    const double length = norm(n);
    flat.normals.push_back(length > 0 ? n / length : vec3());
  }
  number_cage_edges(flat, caller);
  return flat;
}

}  // namespace concino::detail
