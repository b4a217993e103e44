// Parts for tests of 3D printing: solids of unit cubes, as meshes of every kind.
#pragma once

#include <concino/convert.hpp>
#include <concino/generate/to_tets.hpp>
#include <concino/generate/to_triangles.hpp>
#include <concino/mesh.hpp>

#include <support/closed_surfaces.hpp>

#include <array>
#include <map>
#include <set>

namespace concino::testing {

/// The cubes of a box of voxels, from `low` up to but without `high`.
inline void add_voxels(std::set<voxel>& voxels, const voxel& low, const voxel& high) {
  for (int i = low[0]; i < high[0]; ++i)
    for (int j = low[1]; j < high[1]; ++j)
      for (int k = low[2]; k < high[2]; ++k) voxels.insert({i, j, k});
}

inline cell_arrays voxel_cells(const std::set<voxel>& voxels) {
  cell_arrays a;
  a.arity = 8;
  std::map<voxel, unsigned> corners;
  for (const voxel& x : voxels)
    for (const voxel& d : {voxel{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}) {
      const voxel at{x[0] + d[0], x[1] + d[1], x[2] + d[2]};
      const auto [it, added] = corners.try_emplace(at, static_cast<unsigned>(a.points.size()));
      if (added) a.points.push_back({at[0], at[1], at[2]});
      a.verts.push_back(vert_id{it->second});
    }
  return a;
}

/// The solid of the voxels, or its surface, as a mesh of kind M. moved(x): the point to which x is moved.
template<class M, class F>
M voxel_part(const std::set<voxel>& voxels, const F& moved) {
  const auto placed = [&](auto arrays) {
    for (vec3& x : arrays.points) x = moved(x);
    return arrays;
  };
  if constexpr (std::is_same_v<M, quadmesh>) return quadmesh(placed(voxel_skin(voxels)));
  else if constexpr (std::is_same_v<M, polygonmesh>) return polygonmesh(placed(voxel_skin(voxels)));
  else if constexpr (std::is_same_v<M, trimesh>) return to_triangles(quadmesh(placed(voxel_skin(voxels))));
  else if constexpr (std::is_same_v<M, hexmesh>) return hexmesh(placed(voxel_cells(voxels)));
  else if constexpr (std::is_same_v<M, tetmesh>) return to_tets(hexmesh(placed(voxel_cells(voxels))));
  else return convert<M>(hexmesh(placed(voxel_cells(voxels))));
}
template<class M>
M voxel_part(const std::set<voxel>& voxels) {
  return voxel_part<M>(voxels, [](const vec3& x) { return x; });
}

/// A T: a stem of 2 x 2 x 4 below a bar of 6 x 2 x 1.
inline std::set<voxel> letter_t() {
  std::set<voxel> v;
  add_voxels(v, {2, 0, 0}, {4, 2, 4});
  add_voxels(v, {0, 0, 4}, {6, 2, 5});
  return v;
}

/// A table: four legs of 1 x 1 x 3 below a top of 5 x 4 x 1.
inline std::set<voxel> table() {
  std::set<voxel> v;
  for (const int i : {0, 4})
    for (const int j : {0, 3}) add_voxels(v, {i, j, 0}, {i + 1, j + 1, 3});
  add_voxels(v, {0, 0, 3}, {5, 4, 4});
  return v;
}

}  // namespace concino::testing
