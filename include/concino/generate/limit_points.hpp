// The points and normals of smooth subdivision surfaces at the verts of a mesh, without subdividing it.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/generate/detail/subdivide/limit_masks.hpp>

namespace concino {

/// The smooth surface to which repeated subdivision leads, at the verts of the mesh.
template<class M>
struct limit_surface {
  vert_map<M, vec3> points;
  vert_map<M, vec3> normals;  // of length 1
};

/// The points to which the verts of m move if subdivide_loop() or subdivide_catmull_clark() is repeated without end,
/// and the normals of the smooth surface there.
/// Needs:  Embedded SurfaceMesh, no temporary; for Loop, all polys have three verts.
/// Result: by vert of m. Normals are on the side from which the polys are counter-clockwise. A normal is 0 where the
///         polys around the vert do not form one fan, and where there is no tangent plane: at inner verts with two
///         polys, at straight corners of the boundary, or if the points are degenerate. At verts of the boundary with
///         more than five triangles (Loop) or three polys (Catmull-Clark) the rules are not smooth; the normal is
///         orthogonal to the boundary and to the direction inside that decreases most slowly.
/// Cost:   O(size of the mesh), plus the squares of the numbers of polys around each vert.
/// Errors: unsupported that names a poly that is no triangle (Loop).
/// Source: Halstead, Kass, DeRose 1993, "Efficient, fair interpolation using Catmull-Clark surfaces"; Hoppe et al.
///         1994; at the boundary by the left eigenvectors of the rules of subdivision there.
template<class M>
  requires SurfaceMesh<M> && Embedded<M> && requirement::is_lvalue_or_view<M>
limit_surface<std::remove_cvref_t<M>> loop_limit(M&& m) {
  using mesh = std::remove_cvref_t<M>;
  for (const poly_t<mesh> p : polys(m)) detail::triangle_elements<mesh>("loop_limit", m, p);
  return detail::limit_of<detail::smooth_scheme::loop, limit_surface<mesh>>(
      m, detail::loop_rule<mesh, detail::no_creases>{m, detail::no_creases()});
}
template<class M>
  requires SurfaceMesh<M> && Embedded<M> && requirement::is_lvalue_or_view<M>
limit_surface<std::remove_cvref_t<M>> catmull_clark_limit(M&& m) {
  using mesh = std::remove_cvref_t<M>;
  return detail::limit_of<detail::smooth_scheme::catmull_clark, limit_surface<mesh>>(
      m, detail::catmull_clark_rule<mesh, detail::no_creases>{m, detail::no_creases()});
}

// What to write instead of calls that cannot compile.
template<class... T> void loop_limit(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void loop_limit(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void loop_limit(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void catmull_clark_limit(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void catmull_clark_limit(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void catmull_clark_limit(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
