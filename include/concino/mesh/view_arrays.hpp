// view_tri(V, F) and its siblings: a mesh out of arrays that somebody else keeps. Which arrays: <concino/adapters/eigen.hpp> reads Eigen's
// matrices, <concino/adapters/span.hpp> spans and containers; one view may take its points from the one and its polys from the other.
//
// The view owns the adjacencies that the arrays do not say. point(m, v) reads the user's array and, if that may be written, set_point
// writes it; what the user writes there is what the mesh has. adj_p2v(m, p), of polyhedra adj_f2v(m, f), reads the user's array too, but
// polys may not change under a view: make a new one. A container or matrix with a name is kept by its address: it must stay there as long
// as the view is used, and keep its size.
#pragma once

#include <concino/mesh/detail/input_arrays.hpp>

namespace concino {

namespace requirement {

/// What a view may read later: an array with a name, or an object that only points to one (a span, an Eigen::Map).
template<class A> concept is_lvalue_or_view_array = std::is_lvalue_reference_v<A> || concino::detail::source_of<A>::is_view;
/// Points in rows of 3 (or 2) numbers; lists of N indices in rows; numbers one after another. An adapter header says how each is read.
template<class A> concept is_point_array = concino::detail::holds_points<A> && is_lvalue_or_view_array<A>;
template<class A, unsigned N> concept is_list_array = concino::detail::holds_lists<A, N> && is_lvalue_or_view_array<A>;
template<class A> concept is_index_array = concino::detail::holds_indices<A> && is_lvalue_or_view_array<A>;
template<class A>
concept is_temporary_array = (concino::detail::holds_points<A> || concino::detail::holds_lists<A, 3> || concino::detail::holds_lists<A, 4> ||
                              concino::detail::holds_lists<A, 8> || concino::detail::holds_indices<A>) && !is_lvalue_or_view_array<A>;
template<class A> concept is_signed_index_array = is_index_array<A> && std::signed_integral<concino::detail::number_in<A>>;

}  // namespace requirement

/// A surface of triangles or quads, a volume of tets or hexes: row i of `poly_verts` has the verts of poly i, in the order of the native
/// meshes.
/// Needs:  points: rows of 3 coordinates, or of 2 where the type fixes that (z is 0 then); poly_verts: rows of 3, 4, 4, 8 integers of any
///         type. Neither is a temporary, except spans and maps.
/// Result: a view that models TriMesh, QuadMesh, TetMesh or HexMesh, Embedded, and MutablePoints if the points may be written. Verts and
///         polys are numbered as the rows. Copies share their adjacencies.
/// Cost:   linear in time and memory, as for a native mesh without its points and lists; these are not copied, but that indices are held
///         in 32 bits while the view is being made.
/// Errors: invalid_mesh that names the poly with an index that is negative or too large or there twice, or an array of the wrong shape.
template<class P, class F>
  requires requirement::is_point_array<P> && requirement::is_list_array<F, 3>
auto view_tri(P&& points, F&& poly_verts) {
  return detail::view_of_lists<2, 3, detail::tri_tables_of>(points, poly_verts, "view_tri");
}
template<class P, class F>
  requires requirement::is_point_array<P> && requirement::is_list_array<F, 4>
auto view_quad(P&& points, F&& poly_verts) {
  return detail::view_of_lists<2, 4, detail::quad_tables_of>(points, poly_verts, "view_quad");
}
template<class P, class T>
  requires requirement::is_point_array<P> && requirement::is_list_array<T, 4>
auto view_tet(P&& points, T&& poly_verts) {
  return detail::view_of_lists<3, 4, detail::tet_tables_of>(points, poly_verts, "view_tet");
}
template<class P, class H>
  requires requirement::is_point_array<P> && requirement::is_list_array<H, 8>
auto view_hex(P&& points, H&& poly_verts) {
  return detail::view_of_lists<3, 8, detail::hex_tables_of>(points, poly_verts, "view_hex");
}

/// A volume of tets or hexes whose rows name the corners in another order than the native meshes: view_hex(V, H, hex_order::lexicographic).
/// Needs:  as view_tet and view_hex; order: the one of <concino/mesh/corner_orders.hpp> that fits all rows.
/// Result: as view_tet and view_hex. adj_p2v(m, p) reads the user's array in the standard order.
/// Cost:   as view_tet and view_hex; each vert of adj_p2v is found through a table of 4 or 8 numbers.
/// Errors: invalid_mesh as view_tet and view_hex. Whether the order is right only the points show: validate(m) says which it looks like.
template<class P, class T>
  requires requirement::is_point_array<P> && requirement::is_list_array<T, 4>
auto view_tet(P&& points, T&& poly_verts, tet_order order) {
  return detail::view_of_cells<detail::tet_tables_of>(points, poly_verts, order, "view_tet");
}
template<class P, class H>
  requires requirement::is_point_array<P> && requirement::is_list_array<H, 8>
auto view_hex(P&& points, H&& poly_verts, hex_order order) {
  return detail::view_of_cells<detail::hex_tables_of>(points, poly_verts, order, "view_hex");
}

/// A surface of polygons: poly i has the verts indices[offsets[i]] .. indices[offsets[i + 1] - 1], in cyclic order.
/// Needs:  as view_tri; offsets: one more than there are polys, from 0 to the number of indices.
/// Result: a view that models SurfaceMesh, and the rest as view_tri.
/// Cost:   as view_tri; offsets are held in 32 bits, with the edges of polys.
/// Errors: invalid_mesh as view_tri, or that names the offset which decreases or leads out of the indices.
template<class P, class O, class I>
  requires requirement::is_point_array<P> && requirement::is_index_array<O> && requirement::is_index_array<I>
auto view_polygons(P&& points, O&& offsets, I&& indices) {
  return detail::view_of_polygons(points, offsets, indices, "view_polygons");
}

/// A volume of polyhedra: faces are lists of verts in cyclic order, polys are lists of faces, both between offsets. outward[k] says (not 0)
/// that face poly_faces[k] runs counter-clockwise seen from outside its poly. Without `outward`, poly_faces[k] says so itself: f is a face
/// that runs so, and ~f, which is -f - 1, one that runs the other way.
/// Needs:  as view_polygons; poly_faces of a signed type where there is no `outward`.
/// Result: a view that models VolumeMesh, and the rest as view_tri. Faces are numbered as given.
/// Cost:   as view_polygons; faces of polys are held with what lies across them.
/// Errors: invalid_mesh as view_polygons, of faces and polys; unsupported as polyhedralmesh.
template<class P, class FO, class FV, class PO, class PF, class W>
  requires requirement::is_point_array<P> && requirement::is_index_array<FO> && requirement::is_index_array<FV> &&
           requirement::is_index_array<PO> && requirement::is_index_array<PF> && detail::holds_numbers<W>
auto view_polyhedra(P&& points, FO&& face_offsets, FV&& face_verts, PO&& poly_offsets, PF&& poly_faces, const W& outward) {
  return detail::view_of_polyhedra(points, face_offsets, face_verts, poly_offsets, poly_faces, detail::flags_in(outward), "view_polyhedra");
}
template<class P, class FO, class FV, class PO, class PF>
  requires requirement::is_point_array<P> && requirement::is_index_array<FO> && requirement::is_index_array<FV> &&
           requirement::is_index_array<PO> && requirement::is_signed_index_array<PF>
auto view_polyhedra(P&& points, FO&& face_offsets, FV&& face_verts, PO&& poly_offsets, PF&& poly_faces) {
  return detail::view_of_polyhedra(points, face_offsets, face_verts, poly_offsets, poly_faces, detail::signs{}, "view_polyhedra");
}

// What to write instead of calls that cannot compile.
namespace mistake {
inline constexpr sentence name_the_array("the view reads the array later, which must not be a temporary: give the array a name, auto points = ...;");
}
template<class R = mistake::remedy<mistake::name_the_array>, class... A>
  requires(... || requirement::is_temporary_array<A>)
void view_tri(A&&... arrays) = delete;  // give the array a name: auto points = ...;
template<class R = mistake::remedy<mistake::name_the_array>, class... A>
  requires(... || requirement::is_temporary_array<A>)
void view_quad(A&&... arrays) = delete;  // give the array a name: auto points = ...;
template<class R = mistake::remedy<mistake::name_the_array>, class... A>
  requires(... || requirement::is_temporary_array<A>)
void view_tet(A&&... arrays) = delete;  // give the array a name: auto points = ...;
template<class R = mistake::remedy<mistake::name_the_array>, class... A>
  requires(... || requirement::is_temporary_array<A>)
void view_hex(A&&... arrays) = delete;  // give the array a name: auto points = ...;
template<class R = mistake::remedy<mistake::name_the_array>, class... A>
  requires(... || requirement::is_temporary_array<A>)
void view_polygons(A&&... arrays) = delete;  // give the array a name: auto points = ...;
template<class R = mistake::remedy<mistake::name_the_array>, class P, class FO, class FV, class PO, class PF, class... W>
  requires(requirement::is_temporary_array<P> || requirement::is_temporary_array<FO> || requirement::is_temporary_array<FV> ||
           requirement::is_temporary_array<PO> || requirement::is_temporary_array<PF>)
void view_polyhedra(P&&, FO&&, FV&&, PO&&, PF&&, W&&...) = delete;  // give the array a name: auto points = ...;

}  // namespace concino
