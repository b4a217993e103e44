// Disks for tests of UV maps: pieces of cylinders and cones, surfaces over a square, random polygons, all disks of the corpus.
#pragma once

#include <concino/core/vec3.hpp>
#include <concino/generate/voronoi_polygons.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/quadmesh.hpp>
#include <concino/mesh/trimesh.hpp>

#include <support/corpus_meshes.hpp>
#include <support/kinds.hpp>
#include <support/motions.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <variant>
#include <vector>

namespace concino::testing {

/// A grid of n x n cells whose points (x, y) in the unit square are moved to f(x, y).
template<class M, class F>
M grid_on(unsigned n, const F& f) {
  auto a = grid_arrays<M>(n);
  for (vec3& x : a.points) x = f(x.x, x.y);
  return M(std::move(a));
}

/// A rectangle, rolled up to a cylinder or a cone: polys of three verts are as flat as in the plane, others nearly.
inline vec3 on_cylinder(double x, double y) { return {std::cos(2 * x) / 2, std::sin(2 * x) / 2, y}; }
inline vec3 on_cone(double x, double y) {
  const double r = 1 + y, angle = x, slope = 0.6;  // of a sector with the angle x * slope
  return {r * slope * std::cos(angle), r * slope * std::sin(angle), r * std::sqrt(1 - slope * slope)};
}
inline vec3 on_hill(double x, double y) { return {x, 1.5 * y + 0.2 * x, 0.4 * std::sin(3 * x) * std::cos(2.5 * y)}; }

/// Random convex polygons, bent to a hill.
inline polygonmesh random_polygons(unsigned seed, std::size_t count, bool bent = true) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.001, 0.999);
  std::vector<vec3> sites;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = unit(random);
    sites.push_back({x, unit(random), 0});
  }
  const polygonmesh flat = voronoi_polygons(sites, box{{0, 0, 0}, {1, 1, 0}});
  surface_arrays a{{}, {0}, {}, 0};
  for (const auto v : verts(flat)) a.points.push_back(bent ? on_hill(point(flat, v).x, point(flat, v).y) : point(flat, v));
  for (const auto p : polys(flat)) {
    for (const auto v : adj_p2v(flat, p)) a.verts.push_back(v);
    a.offsets.push_back(static_cast<std::uint32_t>(a.verts.size()));
  }
  return polygonmesh(std::move(a));
}

/// The same surface with its verts numbered backwards: vert v becomes n - 1 - v.
inline surface_arrays numbered_backwards(surface_arrays a) {
  const auto n = static_cast<unsigned>(a.points.size());
  std::reverse(a.points.begin(), a.points.end());
  for (auto& v : a.verts) v = vert_id{n - 1 - v.raw()};
  return a;
}

/// Checks that a map of a hill does not depend on its direction and on numbers of verts, and scales exactly. `map(mesh)` has `uv` and `energies`.
template<class Map>
void check_motions_and_numbers(const Map& map, double tolerance) {
  auto arrays = grid_arrays<trimesh>(5);
  for (vec3& x : arrays.points) x = on_hill(x.x, x.y);
  const trimesh m(arrays), turned(rotated(arrays)), large(scaled(arrays, std::ldexp(1.0, 300))), other(numbered_backwards(arrays));
  const auto a = map(m), b = map(turned), c = map(large), e = map(other);
  for (const auto v : verts(m))
    for (std::size_t k = 0; k < 2; ++k) {
      CHECK(std::abs(b.uv[v][k] - a.uv[v][k]) < tolerance);
      CHECK(c.uv[v][k] == std::ldexp(a.uv[v][k], 300));
      CHECK(std::abs(e.uv[vert_id{arrays.points.size() - 1 - v.raw()}][k] - a.uv[v][k]) < tolerance);
    }
  CHECK(c.energies == a.energies);
}

/// Calls f(name, mesh) for each surface of the corpus that is a disk.
template<class F>
void for_each_corpus_disk(const F& f) {
  for (const corpus_row& row : corpus_meshes()) {
    const auto is = [&](const char* name, const char* value) {
      const auto it = row.column.find(name);
      return it != row.column.end() && it->second == value;
    };
    if (!is("euler_chi", "1") || !is("components", "1") || !is("boundary_loops", "1") || !is("manifold", "yes")) continue;
    const auto any = load_any(row.file.string());
    std::visit(
        [&](const auto& m) {
          if constexpr (dimension_v<decltype(m)> == 2) f(row.name, m);
        },
        any);
  }
}

}  // namespace concino::testing
