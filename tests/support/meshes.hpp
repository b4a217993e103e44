// Small meshes for tests, as arrays: grids of every kind on the unit square and the unit cube, with n cells along each edge.
#pragma once

#include <concino/mesh/arrays.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace concino::testing {

inline std::vector<vec3> square_points(unsigned n) {
  std::vector<vec3> x;
  for (unsigned j = 0; j <= n; ++j)
    for (unsigned i = 0; i <= n; ++i) x.push_back({double(i) / n, double(j) / n, 0});
  return x;
}

inline surface_arrays quad_grid(unsigned n) {
  surface_arrays s{square_points(n), {}, {}, 4};
  for (unsigned j = 0; j < n; ++j)
    for (unsigned i = 0; i < n; ++i)
      for (const unsigned v : {j * (n + 1) + i, j * (n + 1) + i + 1, (j + 1) * (n + 1) + i + 1, (j + 1) * (n + 1) + i}) s.verts.push_back(vert_id{v});
  return s;
}

inline surface_arrays triangle_grid(unsigned n) {
  const surface_arrays q = quad_grid(n);
  surface_arrays s{q.points, {}, {}, 3};
  for (std::size_t c = 0; c < q.verts.size(); c += 4)
    for (const std::size_t k : {0u, 1u, 2u, 0u, 2u, 3u}) s.verts.push_back(q.verts[c + k]);
  return s;
}

/// n x n blocks, each of an L with eight verts (concave, with flat corners) and a quad that completes it to a square.
inline surface_arrays polygon_grid(unsigned n) {
  const unsigned w = 2 * n + 1;
  surface_arrays s{square_points(2 * n), {0}, {}, 0};
  const auto polygon = [&](unsigned corner, std::initializer_list<std::array<unsigned, 2>> at) {
    for (const auto& [i, j] : at) s.verts.push_back(vert_id{corner + j * w + i});
    s.offsets.push_back(static_cast<std::uint32_t>(s.verts.size()));
  };
  for (unsigned b = 0; b < n; ++b)
    for (unsigned a = 0; a < n; ++a) {
      polygon(2 * (b * w + a), {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 1}});
      polygon(2 * (b * w + a), {{1, 1}, {2, 1}, {2, 2}, {1, 2}});
    }
  return s;
}

/// The same surface with offsets instead of an arity.
inline surface_arrays with_offsets(surface_arrays s) {
  if (s.arity == 0) return s;
  for (std::size_t i = 0; i <= s.verts.size(); i += s.arity) s.offsets.push_back(static_cast<std::uint32_t>(i));
  s.arity = 0;
  return s;
}

inline std::vector<vec3> cube_points(unsigned n) {
  std::vector<vec3> x;
  for (unsigned k = 0; k <= n; ++k)
    for (unsigned j = 0; j <= n; ++j)
      for (unsigned i = 0; i <= n; ++i) x.push_back({double(i) / n, double(j) / n, double(k) / n});
  return x;
}

inline cell_arrays hex_grid(unsigned n) {
  cell_arrays c{cube_points(n), {}, 8};
  const unsigned w = n + 1;
  for (unsigned k = 0; k < n; ++k)
    for (unsigned j = 0; j < n; ++j)
      for (unsigned i = 0; i < n; ++i)
        for (const unsigned up : {k, k + 1})
          for (const unsigned v : {(up * w + j) * w + i, (up * w + j) * w + i + 1, (up * w + j + 1) * w + i + 1, (up * w + j + 1) * w + i})
            c.verts.push_back(vert_id{v});
  return c;
}

/// Six tets per cube around its diagonal (Kuhn), so that neighbouring cubes are conforming.
inline cell_arrays tet_grid(unsigned n) {
  const cell_arrays h = hex_grid(n);
  cell_arrays c{h.points, {}, 4};
  for (std::size_t i = 0; i < h.verts.size(); i += 8)
    for (const auto& t : {std::array{0, 1, 2, 6}, std::array{0, 2, 3, 6}, std::array{0, 3, 7, 6}, std::array{0, 7, 4, 6}, std::array{0, 4, 5, 6}, std::array{0, 5, 1, 6}})
      for (const int k : t) c.verts.push_back(h.verts[i + static_cast<std::size_t>(k)]);
  return c;
}

/// The prisms over the polys of a surface in the plane z = 0, in layers up to z = 1. Caps may have any number of verts.
inline polyhedra_arrays extrude(const surface_arrays& surface, unsigned layers) {
  const surface_arrays s = with_offsets(surface);
  const auto nv = static_cast<unsigned>(s.points.size()), np = static_cast<unsigned>(s.num_polys());
  polyhedra_arrays r{{}, {0}, {}, {0}, {}, {}};
  const auto close_face = [&] { r.face_offsets.push_back(static_cast<std::uint32_t>(r.face_verts.size())); };
  for (unsigned l = 0; l <= layers; ++l) {
    for (const vec3& p : s.points) r.points.push_back(p + vec3{0, 0, double(l) / layers});
    for (unsigned p = 0; p < np; ++p) {
      for (auto i = s.offsets[p]; i < s.offsets[p + 1]; ++i) r.face_verts.push_back(vert_id{l * nv + s.verts[i].raw()});
      close_face();
    }
  }
  std::map<std::array<unsigned, 3>, unsigned> walls;
  for (unsigned l = 0; l < layers; ++l)
    for (unsigned p = 0; p < np; ++p) {
      const auto add = [&](unsigned face, bool out) {
        r.poly_faces.push_back(face_id{face});
        r.outward.push_back(out);
      };
      add(l * np + p, false);
      add((l + 1) * np + p, true);
      for (auto i = s.offsets[p]; i < s.offsets[p + 1]; ++i) {
        const unsigned a = s.verts[i].raw(), b = s.verts[i + 1 < s.offsets[p + 1] ? i + 1 : s.offsets[p]].raw();
        const auto known = walls.find({l, b, a});
        if (known != walls.end()) {
          add(known->second, false);
          continue;
        }
        walls[{l, a, b}] = static_cast<unsigned>(r.num_faces());
        add(static_cast<unsigned>(r.num_faces()), true);
        for (const unsigned v : {l * nv + a, l * nv + b, (l + 1) * nv + b, (l + 1) * nv + a}) r.face_verts.push_back(vert_id{v});
        close_face();
      }
      r.poly_offsets.push_back(static_cast<std::uint32_t>(r.poly_faces.size()));
    }
  return r;
}

/// Prisms over polygon_grid: concave polyhedra of 6 and 10 faces.
inline polyhedra_arrays polyhedra_grid(unsigned n) { return extrude(polygon_grid(n), n); }

/// Moves every point randomly by at most `amount` in x, y and, if in_space, z. The same seed gives the same result on every machine.
template<class Arrays>
Arrays jittered(Arrays a, double amount, bool in_space = true, unsigned seed = 1) {
  std::mt19937 random(seed);
  const auto d = [&] { return amount * (2.0 * static_cast<double>(random()) / 4294967295.0 - 1); };
  for (vec3& p : a.points) {
    p.x += d();
    p.y += d();
    if (in_space) p.z += d();
  }
  return a;
}

/// The arrays with every coordinate multiplied by 2^exponent.
template<class Arrays>
Arrays scaled_by_power_of_two(Arrays a, int exponent) {
  for (vec3& x : a.points) x = {std::ldexp(x.x, exponent), std::ldexp(x.y, exponent), std::ldexp(x.z, exponent)};
  return a;
}

}  // namespace concino::testing
