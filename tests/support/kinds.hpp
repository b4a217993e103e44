// The lists of kinds of mesh for TEST_CASE_TEMPLATE, and a grid of each kind. If CONCINO_TEST_FEW_KINDS is defined, CONCINO_KINDS are one surface
// and one volume, which take half as long to compile; CONCINO_ALL_KINDS are always all.
#pragma once

#include <concino/mesh/hexmesh.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>
#include <concino/mesh/quadmesh.hpp>
#include <concino/mesh/tetmesh.hpp>
#include <concino/mesh/trimesh.hpp>

#include <support/meshes.hpp>

#define CONCINO_ALL_SURFACE_KINDS concino::trimesh, concino::quadmesh, concino::polygonmesh
#define CONCINO_ALL_VOLUME_KINDS concino::tetmesh, concino::hexmesh, concino::polyhedralmesh
#define CONCINO_ALL_KINDS CONCINO_ALL_SURFACE_KINDS, CONCINO_ALL_VOLUME_KINDS

// Of a list of types, such as meshes of other libraries with different traits: all of them, or the first.
#ifdef CONCINO_TEST_FEW_KINDS
#define CONCINO_FIRST_OF(first, ...) first
#else
#define CONCINO_FIRST_OF(...) __VA_ARGS__
#endif

#ifdef CONCINO_TEST_FEW_KINDS
#define CONCINO_SURFACE_KINDS concino::polygonmesh
#define CONCINO_VOLUME_KINDS concino::tetmesh
#else
#define CONCINO_SURFACE_KINDS CONCINO_ALL_SURFACE_KINDS
#define CONCINO_VOLUME_KINDS CONCINO_ALL_VOLUME_KINDS
#endif
#define CONCINO_KINDS CONCINO_SURFACE_KINDS, CONCINO_VOLUME_KINDS

namespace concino::testing {

template<class M> struct grid_of;
template<> struct grid_of<trimesh> { static surface_arrays make(unsigned n) { return triangle_grid(n); } };
template<> struct grid_of<quadmesh> { static surface_arrays make(unsigned n) { return quad_grid(n); } };
template<> struct grid_of<polygonmesh> { static surface_arrays make(unsigned n) { return polygon_grid(n); } };
template<> struct grid_of<tetmesh> { static cell_arrays make(unsigned n) { return tet_grid(n); } };
template<> struct grid_of<hexmesh> { static cell_arrays make(unsigned n) { return hex_grid(n); } };
template<> struct grid_of<polyhedralmesh> { static polyhedra_arrays make(unsigned n) { return polyhedra_grid(n); } };

/// The arrays of a mesh of kind M over the unit square or cube, with n cells (or blocks of cells) along each edge.
template<class M> auto grid_arrays(unsigned n) { return grid_of<M>::make(n); }
template<class M> M grid(unsigned n) { return M(grid_arrays<M>(n)); }

/// Two disjoint grids, and one isolated vert.
template<class M> auto two_grids_arrays(unsigned n) {
  auto a = grid_arrays<M>(n);
  const auto shift = static_cast<unsigned>(a.points.size());
  const std::vector<vec3> first = a.points;
  for (const vec3& p : first) a.points.push_back(p + vec3{2, 0, 0});
  a.points.push_back({5, 5, 5});
  const auto twice = [](auto& ids, unsigned by) {
    const auto half = ids;
    for (const auto x : half) ids.push_back(static_cast<std::remove_cvref_t<decltype(x)>>(x.raw() + by));
  };
  const auto continue_offsets = [](auto& offsets) {
    const auto half = offsets;
    for (std::size_t i = 1; i < half.size(); ++i) offsets.push_back(half.back() + half[i]);
  };
  if constexpr (requires { a.face_verts; }) {
    const auto faces = static_cast<unsigned>(a.num_faces());
    twice(a.face_verts, shift);
    twice(a.poly_faces, faces);
    continue_offsets(a.face_offsets);
    continue_offsets(a.poly_offsets);
    const auto half = a.outward;
    a.outward.insert(a.outward.end(), half.begin(), half.end());
  } else {
    if constexpr (requires { a.offsets; }) {
      if (a.arity == 0) continue_offsets(a.offsets);
    }
    twice(a.verts, shift);
  }
  return a;
}
template<class M> M two_grids(unsigned n) { return M(two_grids_arrays<M>(n)); }

}  // namespace concino::testing
