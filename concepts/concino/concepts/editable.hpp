// EditableSurfaceMesh and EditableVolumeMesh: meshes in which a few polys can be replaced by others at once. All
// editing is done by this one function, `rewire`, so an operator such as a flip or a collapse works on every model
// without knowing how the mesh is stored.
//
// Laws of rewire(m, c, made):
//   ED1  the polys c.polys are gone, apart from the first c.kept, and so are the removed verts; the new polys have the
//        verts that c lists, in this order, the new verts have the points of c, and `made` names them
//   ED2  elements that are not in the cavity keep their descriptors, their indices, their points, their values of named
//        properties and their adjacencies to each other; so do the verts of the cavity that are not removed, apart from
//        adjacencies
//   ED3  an edge or face that an old and a new poly share keeps its descriptor; one that only old polys have is gone,
//        and a new one may take its descriptor
//   ED4  if it throws, the mesh is as before
//   ED5  the n-th new poly has the descriptor of the n-th old one for n < c.kept
//   ED6  split_edge, flip_edge and collapse_edge, where the traits have them, make the same mesh as rewire, or do
//        nothing
//
// A mesh that has operators of its own may offer them; the operators of <concino/edit.hpp> ask them first, and use
// rewire if they have done nothing:
//   std::optional<vert> split_edge(m, e, x)   splits the edge e, and each triangle at it into two, at the new vert,
//                                             whose point is x; returns that vert
//   bool flip_edge(m, e)                      replaces e by the edge between the verts opposite to it, which has the
//                                             descriptor e; returns whether it was done
//   bool collapse_edge(m, e, x)               merges the ends of e, if the link condition holds: the first one remains,
//                                             with the point x; returns whether it was done
// Like rewire, they change nothing if they throw.
#pragma once

#include <concino/concepts/cavity.hpp>
#include <concino/concepts/mesh.hpp>

namespace concino {

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

using editable_mesh_requirements = list<any_mesh_requirements, mutable_points_requirements, rewire_requirement>;
using editable_surface_mesh_requirements =
    list<surface_mesh_requirements, mutable_points_requirements, rewire_requirement>;
using editable_volume_mesh_requirements =
    list<volume_mesh_requirements, mutable_points_requirements, rewire_requirement>;

}  // namespace requirement

template<class M> concept EditableMesh = AnyMesh<M> && MutablePoints<M> && requirement::has_rewire<M>;
template<class M> concept EditableSurfaceMesh = SurfaceMesh<M> && MutablePoints<M> && requirement::has_rewire<M>;
template<class M> concept EditableVolumeMesh = VolumeMesh<M> && MutablePoints<M> && requirement::has_rewire<M>;

namespace requirement {

// Compilers print this line: convert<polygonmesh>(m) and convert<polyhedralmesh>(m) make such meshes of others.
template<class M> concept has_polys_of_any_size = arity_v<M> == 0;  // else convert<polygonmesh>(m), <polyhedralmesh>
template<class M>
concept can_split_edges = arity_v<M> == 0 || arity_v<M> == dimension_v<M> + 1;  // else as above

}  // namespace requirement

/// An EditableMesh whose polys may have any number of verts, such as polygonmesh and polyhedralmesh.
template<class M> concept EditableGeneralMesh = EditableMesh<M> && requirement::has_polys_of_any_size<M>;

/// Fails to compile with one sentence that names the first thing M lacks to be an EditableMesh and what to write.
template<class M>
consteval void explain_editable_mesh() {
  if constexpr (!EditableMesh<M>)
    requirement::first_missing<requirement::editable_mesh_requirements, M>::template explain<M>();
}

/// Fails to compile with one sentence that names the first thing M lacks to be an EditableSurfaceMesh and what to
/// write.
template<class M>
consteval void explain_editable_surface_mesh() {
  if constexpr (!EditableSurfaceMesh<M>)
    requirement::first_missing<requirement::editable_surface_mesh_requirements, M>::template explain<M>();
}

/// Fails to compile with one sentence that names the first thing M lacks to be an EditableVolumeMesh and what to write.
template<class M>
consteval void explain_editable_volume_mesh() {
  if constexpr (!EditableVolumeMesh<M>)
    requirement::first_missing<requirement::editable_volume_mesh_requirements, M>::template explain<M>();
}

}  // namespace concino
