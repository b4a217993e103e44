// Unit normals of polygons and verts: the directions of vector areas. They do not depend on a triangulation, and
// non-planar polygons have them too.
//
// A normal is the zero vector if there is no area. It does not depend on scale: areas too small or too large for a
// double are handled. Only coordinates that are not finite give NaN.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/core/parallel.hpp>
#include <concino/geometry/detail/any_scale.hpp>
#include <concino/geometry/outer_polygons.hpp>
#include <concino/mesh/element_map.hpp>

#include <cstddef>
#include <vector>

namespace concino {

namespace detail {

/// 1 or -1 for a face of the boundary, by whether it is counter-clockwise seen from outside; 0 for others.
template<class M>
double outward_sign(const M& m, const face_t<M>& f) {
  if (!is_boundary(m, f)) return 0;
  const auto& inside = adj_f2p(m, f);
  return face_is_outward(m, *inside.begin(), f) ? 1 : -1;
}

}  // namespace detail

/// The unit direction of the vector area of poly p of a surface, or of face f of a volume in the order of adj_f2v.
/// Needs:  Embedded SurfaceMesh (poly) or Embedded VolumeMesh (face).
/// Result: length 1, on the side from which the verts are counter-clockwise; 0 without area.      Cost: O(verts of the
///         polygon).
/// Errors: none.
/// Source: Sunday 2002, "Fast polygon area and Newell normal computation".
template<SurfaceMesh M>
  requires Embedded<M>
vec3 normal(const M& m, const poly_t<M>& p) {
  return detail::direction_of_areas(m, [&](const auto& visit) { visit(adj_p2v(m, p), 1.0); });
}
template<VolumeMesh M>
  requires Embedded<M>
vec3 normal(const M& m, const face_t<M>& f) {
  return detail::direction_of_areas(m, [&](const auto& visit) { visit(adj_f2v(m, f), 1.0); });
}

/// The unit direction of the sum of the vector areas around vert v: of the polys at v on a surface; in a volume, of the
/// boundary faces at v, turned outward.
/// Needs:  EmbeddedMesh.
/// Result: length 1; 0 if areas cancel or there are none, as inside a volume.      Cost: O(size of the polygons at v). 
///             Errors: none.
/// Source: weights by area, Taubin 1995, "Estimating the tensor of curvature of a surface from a polyhedral
///         approximation".
template<EmbeddedMesh M>
vec3 vert_normal(const M& m, const vert_t<M>& v) {
  return detail::direction_of_areas(m, [&](const auto& visit) {
    for_each_outer_polygon(
        m, v, [&](const poly_t<M>&, const auto& loop, bool is_outward) { visit(loop, is_outward ? 1.0 : -1.0); });
  });
}

/// The normals of all polys of a surface.
/// Needs:  Embedded SurfaceMesh, no temporary.      Result: a map of vec3, as normal.      Cost: O(corners), parallel. 
///             Errors: none.
template<class M>
  requires requirement::is_lvalue_or_view<M> && SurfaceMesh<M> && Embedded<M>
poly_map<M, vec3> poly_normals(M&& m) {
  poly_map<M, vec3> n(m, poly_index_bound(m), detail::unwritten{});
  parallel_for_each(polys(m), [&](const poly_t<M>& p) { n[p] = normal(m, p); });
  return n;
}

/// The normals of all faces of a volume, each in the order of adj_f2v.
/// Needs:  Embedded VolumeMesh, no temporary.      Result: a map of vec3, as normal.      Cost: O(corners), parallel.  
///            Errors: none.
template<class M>
  requires requirement::is_lvalue_or_view<M> && VolumeMesh<M> && Embedded<M>
face_map<M, vec3> face_normals(M&& m) {
  face_map<M, vec3> n(m, face_index_bound(m), detail::unwritten{});
  parallel_for_each(faces(m), [&](const face_t<M>& f) { n[f] = normal(m, f); });
  return n;
}

namespace detail {

/// Sums vector areas at verts, then normalises the sums and the areas. One thread computes the sums in the order of
/// polys, so that they do not depend on the number of threads; everything else is parallel.
template<class M, class Areas, class Normals>
void sum_areas_of_polys(const M& m, Areas& area, Normals& sum) {
  parallel_for_each(polys(m), [&](const poly_t<M>& p) { area[p] = area_vector_of(m, adj_p2v(m, p)); });
  for (const poly_t<M> p : polys(m)) {
    const vec3 a = area[p];
    for (const vert_t<M> v : adj_p2v(m, p)) sum[v] += a;
  }
  parallel_for_each(verts(m), [&](const vert_t<M>& v) {
    sum[v] = unit_or(sum[v], [&] { return vert_normal(m, v); });
  });
}

template<class M, class Normals>
void sum_areas_of_boundary(const M& m, Normals& sum) {
  std::vector<signed char> sign(face_index_bound(m));
  parallel_for_each(faces(m),
                    [&](const face_t<M>& f) { sign[index_of(m, f)] = static_cast<signed char>(outward_sign(m, f)); });
  std::vector<unsigned char> visited(vert_index_bound(m));
  for (const face_t<M> f : faces(m)) {
    if (sign[index_of(m, f)] == 0) continue;
    const vec3 a = static_cast<double>(sign[index_of(m, f)]) * area_vector_of(m, adj_f2v(m, f));
    for (const vert_t<M> v : adj_f2v(m, f)) {
      visited[index_of(m, v)] = 1;
      sum[v] += a;
    }
  }
  parallel_for_each(verts(m), [&](const vert_t<M>& v) {
    if (visited[index_of(m, v)]) sum[v] = unit_or(sum[v], [&] { return vert_normal(m, v); });
  });
}

}  // namespace detail

/// The unit normals of all verts.
/// Needs:  EmbeddedMesh, no temporary.
/// Result: a map of vec3, as vert_normal except for the order in which areas are summed; the same for any number of
///         threads.
/// Cost:   O(corners) time; every vector area is computed once, and a surface stores one per poly. Parallel except for
///         the sums.
/// Errors: none.
template<class M>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M>
vert_map<M, vec3> vert_normals(M&& m) {
  auto n = make_vert_map<vec3>(m);
  if constexpr (SurfaceMesh<M>) {  // all polys count, so one area per poly can be stored
    poly_map<M, vec3> area(m, poly_index_bound(m), detail::unwritten{});
    detail::sum_areas_of_polys(m, area, n);
  } else {
    detail::sum_areas_of_boundary(m, n);
  }
  return n;
}

/// The results of poly_normals and vert_normals.
template<class M>
struct surface_normals_of {
  poly_map<M, vec3> polys;
  vert_map<M, vec3> verts;
};

/// The normals of all polys and verts of a surface, in about the time of one of the two: no vector area is computed
/// twice.
/// Needs:  Embedded SurfaceMesh, no temporary.      Result: the maps that poly_normals and vert_normals return.
/// Cost:   O(corners); parallel except for the sums at verts.      Errors: none.
template<class M>
  requires requirement::is_lvalue_or_view<M> && SurfaceMesh<M> && Embedded<M>
surface_normals_of<std::remove_cvref_t<M>> surface_normals(M&& m) {
  surface_normals_of<std::remove_cvref_t<M>> n{{m, poly_index_bound(m), detail::unwritten{}}, make_vert_map<vec3>(m)};
  detail::sum_areas_of_polys(m, n.polys, n.verts);
  parallel_for_each(polys(m), [&](const poly_t<M>& p) {
    n.polys[p] = detail::unit_or(n.polys[p], [&] { return normal(m, p); });
  });
  return n;
}

// What to write instead of calls that cannot compile.
template<class... T> void normal(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void normal(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void normal(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0
template<class... T> void vert_normal(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void vert_normal(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void vert_normal(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0
template<class... T> void poly_normals(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void poly_normals(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void poly_normals(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void face_normals(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void face_normals(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void face_normals(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void vert_normals(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void vert_normals(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void vert_normals(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void surface_normals(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void surface_normals(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void surface_normals(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
