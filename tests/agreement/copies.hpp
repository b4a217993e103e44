// Copies any mesh to arrays, with elements numbered in the order of their ranges. Native reference meshes are constructed from these arrays.
#pragma once

#include <concino/mesh/arrays.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>

#include <vector>

namespace concino::agreement {

template<class M>
struct numbering {
  std::vector<unsigned> vert, face;
  std::vector<vec3> points;

  explicit numbering(const M& m) : vert(vert_index_bound(m)) {
    unsigned n = 0;
    for (const auto v : verts(m)) {
      vert[index_of(m, v)] = n++;
      points.push_back(to_vec3(point(m, v)));
    }
    if constexpr (VolumeMesh<M>) {
      face.resize(face_index_bound(m));
      n = 0;
      for (const auto f : faces(m)) face[index_of(m, f)] = n++;
    }
  }
};

template<SurfaceMesh M>
surface_arrays surface_arrays_of(const M& m) {
  const numbering<M> number(m);
  surface_arrays a{number.points, {}, {}, static_cast<std::uint32_t>(arity_v<M>)};
  if (arity_v<M> == 0) a.offsets.push_back(0);
  for (const auto p : polys(m)) {
    for (const auto v : adj_p2v(m, p)) a.verts.push_back(vert_id{number.vert[index_of(m, v)]});
    if (arity_v<M> == 0) a.offsets.push_back(static_cast<std::uint32_t>(a.verts.size()));
  }
  return a;
}

template<VolumeMesh M>
polyhedra_arrays polyhedra_arrays_of(const M& m) {
  const numbering<M> number(m);
  polyhedra_arrays a{number.points, {0}, {}, {0}, {}, {}};
  for (const auto f : faces(m)) {
    for (const auto v : adj_f2v(m, f)) a.face_verts.push_back(vert_id{number.vert[index_of(m, v)]});
    a.face_offsets.push_back(static_cast<std::uint32_t>(a.face_verts.size()));
  }
  for (const auto p : polys(m)) {
    for (const auto f : adj_p2f(m, p)) {
      a.poly_faces.push_back(face_id{number.face[index_of(m, f)]});
      a.outward.push_back(face_is_outward(m, p, f));
    }
    a.poly_offsets.push_back(static_cast<std::uint32_t>(a.poly_faces.size()));
  }
  return a;
}

/// The arrays of a mesh, of the type from which meshes of kind K are constructed.
template<class K, class M>
auto arrays_of(const M& m) {
  if constexpr (SurfaceMesh<M>) {
    return surface_arrays_of(m);
  } else if constexpr (arity_v<K> > 0) {
    const numbering<M> number(m);
    cell_arrays a{number.points, {}, static_cast<std::uint32_t>(arity_v<K>)};
    for (const auto p : polys(m))
      for (const auto v : adj_p2v(m, p)) a.verts.push_back(vert_id{number.vert[index_of(m, v)]});
    return a;
  } else {
    return polyhedra_arrays_of(m);
  }
}

/// A copy of a mesh as a native mesh without fixed arity.
template<class M>
auto general_copy(const M& m) {
  if constexpr (SurfaceMesh<M>) {
    surface_arrays a = surface_arrays_of(m);
    if (a.arity > 0)
      for (std::size_t i = 0; i <= a.verts.size(); i += a.arity) a.offsets.push_back(static_cast<std::uint32_t>(i));
    a.arity = 0;
    return polygonmesh(std::move(a));
  } else {
    return polyhedralmesh(polyhedra_arrays_of(m));
  }
}

}  // namespace concino::agreement
