// The outer polygons of a mesh: the polys of a surface, or the boundary faces of a volume. Also those of its visible
// part, if some polys are hidden.
#pragma once

#include <concino/concepts/facets.hpp>
#include <concino/concepts/maps.hpp>
#include <concino/core/mistakes.hpp>

#include <cstddef>
#include <type_traits>

namespace concino {

namespace detail {

template<class M> struct polygon_of {};
template<SurfaceMesh M> struct polygon_of<M> { using type = poly_t<M>; };
template<VolumeMesh M> struct polygon_of<M> { using type = face_t<M>; };

/// The only visible poly of a facet, if there is exactly one, and whether the facet has hidden ones, too.
template<class M>
struct single_visible_poly {
  poly_t<M> poly{};
  bool is_single = false, has_hidden = false;

  template<class R, class IsVisible>
  single_visible_poly(const R& polys_of_facet, const IsVisible& is_visible) {
    for (const poly_t<M> p : polys_of_facet) {
      if (!is_visible(p)) {
        has_hidden = true;
      } else if (is_single) {
        is_single = false;
        break;
      } else {
        poly = p;
        is_single = true;
      }
    }
  }
};

/// Calls visit(p, loop, is_outward, is_exposed, f) for the faces that have exactly one visible poly p. They are exposed
/// if they also have others.
template<class M, class R, class IsVisible, class Visit>
void visit_visible_faces(const M& m, const R& some, const IsVisible& is_visible, const Visit& visit) {
  for (const face_t<M> f : some) {
    const single_visible_poly<M> found(adj_f2p(m, f), is_visible);
    if (found.is_single) visit(found.poly, adj_f2v(m, f), face_is_outward(m, found.poly, f), found.has_hidden, f);
  }
}

template<class M, class R, class Visit>
void visit_outer_faces(const M& m, const R& some, const Visit& visit) {
  visit_visible_faces(
      m, some, [](const poly_t<M>&) { return true; },
      [&](const poly_t<M>& p, const auto& loop, bool is_outward, bool, const face_t<M>&) {
        visit(p, loop, is_outward);
      });
}

}  // namespace detail

/// The type of the elements that are polygons: polys of surfaces, faces of volumes.
template<class M> using polygon_t = typename detail::polygon_of<std::remove_cvref_t<M>>::type;

/// Calls visit(p, loop, is_outward) for each outer polygon of m, or for those at vert v. In a surface p is the polygon,
/// in a volume the poly of the face. loop is the range of its verts; is_outward says whether they are counter-clockwise
/// seen from outside.
/// Needs:  AnyMesh; visit takes poly_t<M>, a range of verts that lives as long as the call, and bool.
/// Result: none. It visits all polys of a surface, or the faces of a volume with exactly one poly, in the order of the
///         mesh.
/// Cost:   O(polys) of a surface, O(faces) of a volume; those at v.      Errors: those of visit.
template<SurfaceMesh M, class Visit>
void for_each_outer_polygon(const M& m, const Visit& visit) {
  for (const poly_t<M> p : polys(m)) visit(p, adj_p2v(m, p), true);
}
template<VolumeMesh M, class Visit>
void for_each_outer_polygon(const M& m, const Visit& visit) { detail::visit_outer_faces(m, faces(m), visit); }
template<SurfaceMesh M, class Visit>
void for_each_outer_polygon(const M& m, const vert_t<M>& v, const Visit& visit) {
  for (const poly_t<M> p : adj_v2p(m, v)) visit(p, adj_p2v(m, p), true);
}
template<VolumeMesh M, class Visit>
void for_each_outer_polygon(const M& m, const vert_t<M>& v, const Visit& visit) {
  detail::visit_outer_faces(m, adj_v2f(m, v), visit);
}

/// Calls visit(p, loop, is_outward, is_exposed, x) for each polygon x that is visible if some polys are hidden. p, loop
/// and is_outward are as above. is_exposed says whether a hidden poly has laid the polygon bare: never in a surface. x
/// is p in a surface, the face in a volume.
/// Needs:  AnyMesh; is_visible[p] is true or false for each poly.
/// Result: none. It visits the visible polys of a surface, or the faces of a volume with exactly one visible poly, in
///         the order of the mesh. If all polys are visible, these are the outer polygons.
/// Cost:   O(polys) of a surface, O(faces) of a volume.      Errors: those of visit.
template<SurfaceMesh M, class Map, class Visit>
  requires ReadableMap<Map, poly_t<M>>
void for_each_visible_polygon(const M& m, const Map& is_visible, const Visit& visit) {
  for (const poly_t<M> p : polys(m))
    if (is_visible[p]) visit(p, adj_p2v(m, p), true, false, p);
}
template<VolumeMesh M, class Map, class Visit>
  requires ReadableMap<Map, poly_t<M>>
void for_each_visible_polygon(const M& m, const Map& is_visible, const Visit& visit) {
  detail::visit_visible_faces(m, faces(m), [&](const poly_t<M>& p) -> bool { return is_visible[p]; }, visit);
}

// What to write instead of calls that cannot compile.
template<class... T> void for_each_outer_polygon(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void for_each_visible_polygon(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()

}  // namespace concino
