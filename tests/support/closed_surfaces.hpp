// Closed surfaces of any genus for tests: boundaries of voxel blocks, tori, Klein bottles and the projective plane.
#pragma once

#include <concino/concepts/mesh_traits.hpp>
#include <concino/mesh/arrays.hpp>

#include <support/meshes.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <vector>

namespace concino::testing {

using voxel = std::array<int, 3>;

/// The boundary squares of a set of voxels, counter-clockwise as seen from outside.
inline surface_arrays voxel_skin(const std::set<voxel>& voxels) {
  surface_arrays s{{}, {}, {}, 4};
  std::map<voxel, unsigned> corners;
  const auto corner = [&](const voxel& x) {
    const auto [it, added] = corners.try_emplace(x, static_cast<unsigned>(s.points.size()));
    if (added) s.points.push_back({double(x[0]), double(x[1]), double(x[2])});
    return vert_id{it->second};
  };
  for (const voxel& x : voxels)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int side : {0, 1}) {
        voxel beyond = x, at = x;
        beyond[axis] += side ? 1 : -1;
        if (voxels.count(beyond)) continue;
        at[axis] += side;
        std::array<voxel, 4> square{at, at, at, at};
        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        ++square[1][u], ++square[2][u], ++square[2][v], ++square[3][v];
        if (!side) std::swap(square[1], square[3]);
        for (const voxel& c : square) s.verts.push_back(corner(c));
      }
  return s;
}

/// A board with `genus` holes in a row.
inline surface_arrays holed_board(int genus) {
  std::set<voxel> voxels;
  for (int i = 0; i < 2 * genus + 1; ++i)
    for (int j = 0; j < 3; ++j)
      if (j != 1 || i % 2 == 0) voxels.insert({i, j, 0});
  return voxel_skin(voxels);
}

/// A grid of n x k squares that is closed in both directions: a torus, or with `turn` a Klein bottle.
inline surface_arrays rolled_grid(unsigned n, unsigned k, bool turn = false) {
  surface_arrays s{{}, {}, {}, 4};
  for (unsigned j = 0; j < k; ++j)
    for (unsigned i = 0; i < n; ++i) {
      const double a = 6.283185307179586 * i / n, b = 6.283185307179586 * j / k;
      s.points.push_back({(3 + std::cos(a)) * std::cos(b), (3 + std::cos(a)) * std::sin(b), std::sin(a)});
    }
  const auto id = [&](unsigned i, unsigned j) {
    if (j == k && turn) i = n - i % n;
    return vert_id{j % k * n + i % n};
  };
  for (unsigned j = 0; j < k; ++j)
    for (unsigned i = 0; i < n; ++i)
      for (const vert_id v : {id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)}) s.verts.push_back(v);
  return s;
}

/// The projective plane with six verts: half an icosahedron.
inline surface_arrays projective_plane() {
  surface_arrays s{std::vector<vec3>(6), {}, {}, 3};
  for (unsigned i = 0; i < 6; ++i) s.points[i] = {double(i), double(i * i), double(i * i * i)};
  for (const unsigned v :
       {0u, 1u, 2u, 0u, 2u, 3u, 0u, 3u, 4u, 0u, 4u, 5u, 0u, 5u, 1u, 1u, 2u, 4u, 2u, 3u, 5u, 3u, 4u, 1u, 4u, 5u, 2u, 5u, 1u, 3u})
    s.verts.push_back(vert_id{v});
  return s;
}

/// The same surface with every quad split into two triangles.
inline surface_arrays triangulated(const surface_arrays& quads) {
  surface_arrays s{quads.points, {}, {}, 3};
  for (std::size_t q = 0; q < quads.verts.size(); q += 4)
    for (const std::size_t k : {0u, 1u, 2u, 0u, 2u, 3u}) s.verts.push_back(quads.verts[q + k]);
  return s;
}

/// The same surface with a vert in the middle of every edge. Quads become octagons, which may share two edges.
inline surface_arrays with_middles(surface_arrays coarse) {
  coarse = with_offsets(coarse);
  surface_arrays s{coarse.points, {0}, {}, 0};
  std::map<std::array<unsigned, 2>, unsigned> middles;
  for (std::size_t p = 0; p < coarse.num_polys(); ++p) {
    for (auto i = coarse.offsets[p]; i < coarse.offsets[p + 1]; ++i) {
      const unsigned a = coarse.verts[i].raw(), b = coarse.verts[i + 1 < coarse.offsets[p + 1] ? i + 1 : coarse.offsets[p]].raw();
      const auto [it, added] = middles.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<unsigned>(s.points.size()));
      if (added) s.points.push_back(0.5 * (coarse.points[a] + coarse.points[b]));
      s.verts.push_back(vert_id{a});
      s.verts.push_back(vert_id{it->second});
    }
    s.offsets.push_back(static_cast<std::uint32_t>(s.verts.size()));
  }
  return s;
}

/// A surface of quads as a mesh of kind M.
template<class M>
M from_quads(const surface_arrays& quads) {
  if constexpr (arity_v<M> == 3) return M(triangulated(quads));
  else if constexpr (arity_v<M> == 4) return M(quads);
  else return M(with_middles(quads));
}

/// The disjoint union of two surfaces of the same arity.
inline surface_arrays beside(surface_arrays a, const surface_arrays& b) {
  const auto shift = static_cast<unsigned>(a.points.size());
  for (const vec3& p : b.points) a.points.push_back(p + vec3{100, 0, 0});
  for (const vert_id v : b.verts) a.verts.push_back(vert_id{v.raw() + shift});
  return a;
}

}  // namespace concino::testing
