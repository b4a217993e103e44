// Maps squares and cubes of cells to disks and balls.
#pragma once

#include <concino/core/vec3.hpp>
#include <concino/mesh/arrays.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Value i of n + 1 values from -1 to 1, spaced so that they divide the edge of a cube into equal angles at its centre.
/// Symmetric to the last bit.
inline double even_angle(std::size_t i, std::size_t n) {
  if (i == 0 || i == n) return i == 0 ? -1 : 1;
  const double t = (2 * static_cast<double>(i) - static_cast<double>(n)) / static_cast<double>(n);
  return std::tan(0.78539816339744830962 * t);
}

/// Maps a point u of the square or cube [-1, 1] to the core of the disk or ball of radius 1. The middle is only scaled.
/// Towards the boundary of the core it becomes rounder, so that neither the cells inside nor those around it become
/// flat.
inline vec3 in_round_core(const vec3& u) {
  const double length = norm(u), far = std::max({std::abs(u.x), std::abs(u.y), std::abs(u.z)});
  if (length == 0) return u;
  return 0.55 * (1 - 0.5 * far * (1 - far / length)) * u;
}
inline vec3 on_round_boundary(const vec3& u) { return u / norm(u); }
/// The number of layers around a core with n cells along each edge, such that layers are about as thick as its cells.
constexpr std::size_t layers_around(std::size_t n) { return (n + 1) / 2; }

/// The dual of a closed, consistently oriented surface of triangles: a vert at point_of(t) for triangle number t, a
/// polygon for each vert.
template<class PointOf>
surface_arrays dual_of_triangles(const surface_arrays& triangles, const PointOf& point_of) {
  struct corner { std::uint32_t from, to, triangle; };
  const auto raw = [&](std::size_t i) { return triangles.verts[i].raw(); };
  surface_arrays a;
  a.offsets.assign(triangles.points.size() + 1, 0);
  for (const vert_id v : triangles.verts) ++a.offsets[v.raw() + 1];
  for (std::size_t v = 0; v < triangles.points.size(); ++v) a.offsets[v + 1] += a.offsets[v];
  std::vector<std::uint32_t> fill(a.offsets.begin(), a.offsets.end() - 1);
  std::vector<corner> corners(triangles.verts.size());
  a.points.reserve(triangles.num_polys());
  a.verts.reserve(triangles.verts.size());
  for (std::size_t i = 0; i < triangles.verts.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k)
      corners[fill[raw(i + k)]++] = {raw(i + (k + 1) % 3), raw(i + (k + 2) % 3), static_cast<std::uint32_t>(i / 3)};
    a.points.push_back(point_of(i / 3));
  }
  for (std::size_t v = 0; v < triangles.points.size(); ++v) {
    const auto first = corners.begin() + static_cast<std::ptrdiff_t>(a.offsets[v]),
               last = corners.begin() + static_cast<std::ptrdiff_t>(a.offsets[v + 1]);
    std::uint32_t next = first->from;
    for (auto at = first; at != last; ++at) {  // each corner begins where the previous one ends
      std::iter_swap(at, std::find_if(at, last, [&](const corner& c) { return c.from == next; }));
      next = at->to;
      a.verts.push_back(vert_id{at->triangle});
    }
  }
  return a;
}

}  // namespace concino::detail
