// The flat arrays of a native mesh whose elements are numbered without gaps, from which the same mesh can be built.
#pragma once

#include <concino/mesh.hpp>

namespace bench {

inline concino::surface_arrays arrays_of(const concino::polygonmesh& m) {
  concino::surface_arrays a;
  a.points = m.points();
  a.offsets.push_back(0);
  for (const auto p : concino::polys(m)) {
    for (const auto v : concino::adj_p2v(m, p)) a.verts.push_back(v);
    a.offsets.push_back(static_cast<std::uint32_t>(a.verts.size()));
  }
  return a;
}

/// Triangles, quads, tets or hexes.
template<class M>
  requires(concino::arity_v<M> != 0)
auto arrays_of(const M& m) {
  std::conditional_t<concino::dimension_v<M> == 2, concino::surface_arrays, concino::cell_arrays> a;
  a.arity = static_cast<std::uint32_t>(concino::arity_v<M>);
  a.points = m.points();
  for (const auto p : concino::polys(m))
    for (const auto v : concino::adj_p2v(m, p)) a.verts.push_back(v);
  return a;
}

inline concino::polyhedra_arrays arrays_of(const concino::polyhedralmesh& m) {
  concino::polyhedra_arrays a;
  a.points = m.points();
  a.face_offsets.push_back(0);
  a.poly_offsets.push_back(0);
  for (const auto f : concino::faces(m)) {
    for (const auto v : concino::adj_f2v(m, f)) a.face_verts.push_back(v);
    a.face_offsets.push_back(static_cast<std::uint32_t>(a.face_verts.size()));
  }
  for (const auto p : concino::polys(m)) {
    for (const auto f : concino::adj_p2f(m, p)) {
      a.poly_faces.push_back(f);
      a.outward.push_back(concino::face_is_outward(m, p, f));
    }
    a.poly_offsets.push_back(static_cast<std::uint32_t>(a.poly_faces.size()));
  }
  return a;
}

}  // namespace bench
