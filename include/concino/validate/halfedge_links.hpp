// assert_halfedge_links: can the half-edges of a mesh hold what it is made of, and are they linked as halfedge_kernel needs? The laws HE1 ..
// HE4 of <concino/concepts/halfedge_kernel.hpp>.
#pragma once

#include <concino/core/error.hpp>
#include <concino/validate/detail/halfedge_laws.hpp>

namespace concino {

/// Throws unless the half-edges of m are linked as halfedge_kernel needs, and m is a surface that half-edges can hold.
/// Needs:  SurfaceMesh M whose mesh_traits come from halfedge_kernel.
/// Result: none. Of m nothing but its half-edges is looked at; check_laws(m) includes this and looks at all the rest.
/// Cost:   O(half-edges) time and memory.
/// Errors: invalid_mesh that names the cause: a vert with several fans of polys, an edge of more than two, polys whose orientations disagree,
///         border half-edges that do not exist, or the link that is wrong.
template<class M>
  requires detail::halfedge_mesh<M>
void assert_halfedge_links(const M& m) {
  detail::law_log log;
  detail::halfedge_laws<M> laws(m, log);
  if (!laws.read_elements_of_mesh(log) || !laws.check())
    core::throw_joined<invalid_mesh>({"half-edges: ", log.take().front().what});
}

}  // namespace concino
