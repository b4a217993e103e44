// assert_halfedge_links: checks that the half-edges of a surface are linked as halfedge_kernel requires. The laws HE1
// ..
// HE4 of <concino/concepts/halfedge_kernel.hpp>.
#pragma once

#include <concino/core/error.hpp>
#include <concino/validate/detail/halfedge_laws.hpp>

namespace concino {

/// Throws unless the half-edges of m are linked as halfedge_kernel requires, and half-edges can represent the surface
/// m.
/// Needs:  SurfaceMesh M whose mesh_traits come from halfedge_kernel.
/// Result: none. It only examines the half-edges of m; check_laws(m) includes this and checks everything else.
/// Cost:   O(half-edges) time and memory.
/// Errors: invalid_mesh, naming the cause: a vert with several fans of polys, an edge of more than two polys, polys of
///         opposite orientation, missing border half-edges, or the wrong link.
template<class M>
  requires detail::halfedge_mesh<M>
void assert_halfedge_links(const M& m) {
  detail::law_log log;
  detail::halfedge_laws<M> laws(m, log);
  if (!laws.read_elements_of_mesh(log) || !laws.check())
    core::throw_joined<invalid_mesh>({"half-edges: ", log.take().front().what});
}

}  // namespace concino
