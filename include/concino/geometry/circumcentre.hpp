// The circumcentre of triangles and tets.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/small_array.hpp>
#include <concino/geometry/detail/circles/circumsphere.hpp>

namespace concino {

namespace detail {

template<std::size_t corners, class M, class Verts>
vec3 circumcentre_of(const M& m, const Verts& verts, const char* name, std::size_t i) {
  core::small_array<vec3, 8> points(0, vec3());
  for (const vert_t<M> v : verts) points.push_back(to_vec3(point(m, v)));
  if (points.size() != corners)
    core::throw_joined<invalid_argument>(
        {"circumcentre: ", name, i, " has ", points.size(), " verts; only triangles and tets have one"});
  return centre_of_circumsphere({points.data(), points.size()});
}

}  // namespace detail

/// The circumcentre of poly p of a surface or volume, or of face f of a volume: the point in its plane, or in space,
/// that is equally far from its verts.
/// Needs:  EmbeddedMesh. The poly or face is a triangle or a tet, in a mesh of any kind.
/// Result: a point that may lie outside the poly; not finite if the verts lie on one line or in one plane, up to
///         rounding, or if one is not finite. Scales exactly with powers of 2.
/// Cost:   O(1), plus that of adj_p2v.      Errors: invalid_argument if the poly or face has another number of verts.
/// Source: the intersection of the perpendicular bisectors, solved by Cramer's rule.
template<EmbeddedMesh M>
vec3 circumcentre(const M& m, const poly_t<M>& p) {
  return detail::circumcentre_of<dimension_v<M> + 1>(m, adj_p2v(m, p), "poly ", index_of(m, p));
}
template<VolumeMesh M>
  requires Embedded<M>
vec3 circumcentre(const M& m, const face_t<M>& f) {
  return detail::circumcentre_of<3>(m, adj_f2v(m, f), "face ", index_of(m, f));
}

// What to write instead of calls that cannot compile.
template<class... T> void circumcentre(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void circumcentre(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void circumcentre(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0

}  // namespace concino
