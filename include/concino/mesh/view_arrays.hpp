// view_tri(V, F), view_quad(V, F) and so on: mesh views over arrays that the user owns. Adapters read the arrays:
// <concino/adapters/eigen.hpp> reads Eigen matrices, <concino/adapters/span.hpp> spans and containers; the points and
// the polys of one view may come from different adapters. Not part of <concino/mesh.hpp>: the adapters include it.
//
// The view owns only the adjacencies that are not in the arrays. point(m, v) reads the user's array, so it returns the
// latest values; set_point writes it, if it is writable. adj_p2v(m, p), and adj_f2v(m, f) of polyhedra, read the user's
// array too, but polys must not change: make a new view then. Containers and matrices that are named variables are kept
// by address: they must not be moved, destroyed or resized while the view is used.
#pragma once

#include <concino/mesh/detail/views/input_arrays.hpp>

namespace concino {

namespace requirement {

/// An array that a view can read later: a named array, or an object that only points to one (a span, an Eigen::Map).
template<class A>
concept is_lvalue_or_view_array = std::is_lvalue_reference_v<A> || concino::detail::source_of<A>::is_view;
/// Points in rows of 3 (or 2) numbers; lists of N indices in rows; consecutive numbers. An adapter header says how each
/// type is read.
template<class A> concept is_point_array = concino::detail::holds_points<A> && is_lvalue_or_view_array<A>;
template<class A, unsigned N> concept is_list_array = concino::detail::holds_lists<A, N> && is_lvalue_or_view_array<A>;
template<class A> concept is_index_array = concino::detail::holds_indices<A> && is_lvalue_or_view_array<A>;
template<class A>
concept is_temporary_array = (concino::detail::holds_points<A> || concino::detail::holds_lists<A, 3> ||
                              concino::detail::holds_lists<A, 4> || concino::detail::holds_lists<A, 8> ||
                              concino::detail::holds_indices<A>)&&!is_lvalue_or_view_array<A>;
template<class A>
concept is_signed_index_array = is_index_array<A> && std::signed_integral<concino::detail::number_in<A>>;

}  // namespace requirement

/// A surface of triangles or quads, or a volume of tets or hexes: row i of `poly_verts` has the verts of poly i, in the
/// order of the native meshes.
/// Needs:  points: rows of 3 coordinates, or of 2 where the type fixes that (z is 0 then); poly_verts: rows of 3, 4, 4,
///         8 integers of any type. Neither is a temporary, except spans and maps.
/// Result: a view that models TriMesh, QuadMesh, TetMesh or HexMesh, Embedded, and MutablePoints if the points are
///         writable. Verts and polys are numbered as the rows. Copies share their adjacencies.
/// Cost:   linear in time and memory, as for a native mesh without its points and lists. These are not copied, except
///         that indices are stored in 32 bits while the view is built.
/// Errors: invalid_mesh that names the poly with an index that is negative, too large or repeated, or an array of the
///         wrong shape.
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

/// A volume of tets or hexes whose rows give the corners in a different order from the native meshes: view_hex(V, H,
/// hex_order::lexicographic).
/// Needs:  as view_tet and view_hex; order: the one of <concino/mesh/corner_orders.hpp> that fits all rows.
/// Result: as view_tet and view_hex. adj_p2v(m, p) reads the user's array in the standard order.
/// Cost:   as view_tet and view_hex; each vert of adj_p2v is found through a table of 4 or 8 numbers.
/// Errors: invalid_mesh as view_tet and view_hex. A wrong order can be recognised from the points only: validate(m)
///         says which order they suggest.
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
/// Cost:   as view_tri; offsets are stored in 32 bits, with the edges of polys.
/// Errors: invalid_mesh as view_tri, or that names the offset which decreases or is out of range.
template<class P, class O, class I>
  requires requirement::is_point_array<P> && requirement::is_index_array<O> && requirement::is_index_array<I>
auto view_polygons(P&& points, O&& offsets, I&& indices) {
  return detail::view_of_polygons(points, offsets, indices, "view_polygons");
}

/// A volume of polyhedra: faces are lists of verts in cyclic order, polys are lists of faces, both stored with offsets.
/// outward[k] (0 or not 0) says whether face poly_faces[k] runs counter-clockwise seen from outside its poly. Without
/// `outward`, the sign of poly_faces[k] says so: f is a face that runs counter-clockwise, and ~f, which is -f - 1, one
/// that runs clockwise.
/// Needs:  as view_polygons; poly_faces of a signed type if there is no `outward`.
/// Result: a view that models VolumeMesh, and the rest as view_tri. Faces keep the numbers of the input.
/// Cost:   as view_polygons; the faces of polys are stored with the neighbours behind them.
/// Errors: invalid_mesh as view_polygons, of faces and polys; unsupported as polyhedralmesh.
template<class P, class FO, class FV, class PO, class PF, class W>
  requires requirement::is_point_array<P> && requirement::is_index_array<FO> && requirement::is_index_array<FV> &&
           requirement::is_index_array<PO> && requirement::is_index_array<PF> && detail::holds_numbers<W>
auto view_polyhedra(P&& points, FO&& face_offsets, FV&& face_verts, PO&& poly_offsets, PF&& poly_faces,
                    const W& outward) {
  return detail::view_of_polyhedra(points, face_offsets, face_verts, poly_offsets, poly_faces,
                                   detail::flags_in(outward), "view_polyhedra");
}
template<class P, class FO, class FV, class PO, class PF>
  requires requirement::is_point_array<P> && requirement::is_index_array<FO> && requirement::is_index_array<FV> &&
           requirement::is_index_array<PO> && requirement::is_signed_index_array<PF>
auto view_polyhedra(P&& points, FO&& face_offsets, FV&& face_verts, PO&& poly_offsets, PF&& poly_faces) {
  return detail::view_of_polyhedra(points, face_offsets, face_verts, poly_offsets, poly_faces, detail::signs{},
                                   "view_polyhedra");
}

// What to write instead of calls that cannot compile.
namespace mistake {
inline constexpr sentence name_the_array(
    "the view refers to the array, which must not be a temporary: give the array a name, auto points = ...;");
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
template<class R = mistake::remedy<mistake::name_the_array>, class P, class FO, class FV, class PO, class PF,
         class... W>
  requires(requirement::is_temporary_array<P> || requirement::is_temporary_array<FO> ||
           requirement::is_temporary_array<FV> || requirement::is_temporary_array<PO> ||
           requirement::is_temporary_array<PF>)
void view_polyhedra(P&&, FO&&, FV&&, PO&&, PF&&, W&&...) = delete;  // give the array a name: auto points = ...;

}  // namespace concino
