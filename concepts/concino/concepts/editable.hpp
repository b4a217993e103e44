// EditableSurfaceMesh and EditableVolumeMesh: meshes in which a few polys can be replaced by others at once. All editing is done by this one function,
// `rewire`, so an operator such as a flip or a collapse works on every model without knowing how the mesh is stored.
//
// Laws of rewire(m, c, made):
//   ED1  the polys c.polys are gone, apart from the first c.kept; the new ones have the verts that c lists, in this order
//   ED2  elements that are not in the cavity keep their descriptors, their points and their adjacencies to each other
//   ED3  an edge or face that an old and a new poly share keeps its descriptor; one that only old polys have is gone, and a new one may take its descriptor
//   ED4  if it throws, the mesh is as before
//   ED5  the n-th new poly has the descriptor of the n-th old one for n < c.kept
#pragma once

#include <concino/concepts/mesh.hpp>

namespace concino {

struct vec3;  // <concino/core/vec3.hpp>

/// What `rewire` replaces: a few polys of a mesh, and the polys that take their place. All arrays belong to the caller.
/// In surfaces, tets and hexes `ends[k]` is the number of corners of the new polys 0 .. k. In meshes of general polyhedra corners are those of faces, which
/// run counter-clockwise seen from outside their poly; `ends` are where faces end in `corners`, `poly_ends` where polys end in `ends`.
template<class Vert, class Poly>
struct cavity_of {
  id_span<Poly> polys = {};           // old polys, which are removed
  id_span<Vert> verts = {};           // the existing verts of old and new polys, each once
  id_span<vec3> points = {};          // of new verts, which are numbered after `verts`
  id_span<unsigned> corners = {};     // of the new polys, one after another: numbers of `verts` and then of `points`
  id_span<unsigned> ends = {};
  id_span<unsigned> poly_ends = {};   // of general polyhedra only
  std::size_t kept = 0;               // this many new polys have the descriptors of the first old ones
  std::size_t removed = 0;            // this many verts, the last ones of `verts`, are removed: no poly has them afterwards
};

/// Where `rewire` writes the descriptors of new verts and of all new polys, in the order of the cavity.
template<class Vert, class Poly>
struct cavity_result_of {
  Vert* verts = nullptr;
  Poly* polys = nullptr;
};

template<class M> using cavity = cavity_of<vert_t<M>, poly_t<M>>;
template<class M> using cavity_result = cavity_result_of<vert_t<M>, poly_t<M>>;

namespace requirement {

template<class M>
concept has_rewire = requires(std::remove_cvref_t<M>& m, const cavity<M>& c, const cavity_result<M>& made) {
  traits<M>::rewire(m, c, made);
};
struct rewire_requirement {
  template<class M> static constexpr bool holds = has_rewire<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs rewire: static void rewire(M&, const cavity<M>&, const cavity_result<M>&); it replaces polys by others");
  }
};

using editable_surface_mesh_requirements = list<surface_mesh_requirements, mutable_points_requirements, rewire_requirement>;
using editable_volume_mesh_requirements = list<volume_mesh_requirements, mutable_points_requirements, rewire_requirement>;

}  // namespace requirement

template<class M> concept EditableSurfaceMesh = SurfaceMesh<M> && MutablePoints<M> && requirement::has_rewire<M>;
template<class M> concept EditableVolumeMesh = VolumeMesh<M> && MutablePoints<M> && requirement::has_rewire<M>;
template<class M> concept EditableMesh = AnyMesh<M> && MutablePoints<M> && requirement::has_rewire<M>;

/// Fails to compile with one sentence that names the first thing M lacks to be an EditableSurfaceMesh and what to write.
template<class M>
consteval void explain_editable_surface_mesh() {
  if constexpr (!EditableSurfaceMesh<M>) requirement::first_missing<requirement::editable_surface_mesh_requirements, M>::template explain<M>();
}

/// Fails to compile with one sentence that names the first thing M lacks to be an EditableVolumeMesh and what to write.
template<class M>
consteval void explain_editable_volume_mesh() {
  if constexpr (!EditableVolumeMesh<M>) requirement::first_missing<requirement::editable_volume_mesh_requirements, M>::template explain<M>();
}

}  // namespace concino
