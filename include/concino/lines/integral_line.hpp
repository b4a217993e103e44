// integral_line and integral_lines: lines that follow a vector field over a surface or through a volume.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/lines/detail/follow/follow_field.hpp>

#include <type_traits>

namespace concino {

/// The line that follows a vector field from a point: auto line = integral_line(m, gradient(m, u), v);
/// line.points[0].position.
/// Needs:  EmbeddedMesh. g[p], the vector of each poly: of a surface its part in the plane of the polygon counts.
///         start: a vert, a poly (the line starts at its point nearest to the centroid) or a mesh_point: one of a poly
///         on its faces, edges or verts is a place of these, see lowest_element. The parts of points are 0 or from
///         about 1e-60 to 1e60.
/// Result: points, each with its element, and the poly of each segment; see field_line. Only directions of g matter
///         where one poly leads on; speeds decide between several. Inside a poly the line is straight. A planar polygon
///         is not divided, nor is a polyhedron, convex or not: the line leaves it where it meets its surface, which is
///         made of the triangles of polygon_triangulator where faces are not planar. Other polygons, with corners off
///         their plane by more than 1e-9 of the size, are walked over by these triangles. Where the fields on both
///         sides of an edge, or of a face of a volume, push towards each other, the line follows the edge or face, with
///         the mean of both fields whose part across is 0. From a vert, or from an edge of a volume, the line follows
///         the fastest of the polys, faces and edges that lead away from it; of equally fast ones that which comes
///         first by x, y, z. It stops where line_end says. A line that starts on the boundary goes along it only where
///         the field is exactly parallel to it. On surfaces, the place where a line enters a poly is an affine function
///         of the place where it entered it before. By this most lines that never end are recognised. A line is
///         `closed` if it comes back but for rounding; it does not repeat its first point. It `winds_to_cycle` if it
///         comes ever closer to a cycle. A line that goes round a vert ever closer ends there, a `sink`; its length
///         counts all rounds. In volumes only returns are recognised. Some lines, such as those on a torus, run on for
///         ever: max_steps ends them. Where a line leaves a poly is decided by exact signs of determinants of the
///         points. Speeds, and directions along edges and faces, are rounded. The order of elements in m has no
///         influence but by rounding.
/// Cost:   O(P) to check g, and O(size of the polys crossed). Gradients of functions that are linear on triangles or
///         tets bound this: along a line the function increases, also where two fields push together, since their mean
///         is the gradient along the edge or face. So a line never comes back to a vert or cycle. Nor does it go round
///         a vert of triangles: it enters a sector only where the slope along the direction from the vert increases
///         with the angle, which cannot be so all round. So a line passes each sector of a vert at most once. Other
///         fields have no such bound.
/// Errors: invalid_argument if a vector is not finite, naming the poly; if max_length is not above 0. Those of
///         lowest_element about the start. invalid_mesh if a poly on the way has points that are not finite.
/// Source: paper section 2.2, "Fields"; Filippov 1988, "Differential equations with discontinuous righthand sides", for
///         edges and faces along which lines run.
template<class M, class G, class S>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M> && requirement::gives_points<G, poly_t<M>> &&
      requirement::is_line_start<M, S>
auto integral_line(M&& m, const G& g, const S& start, const integral_line_options& options = {}) {
  const detail::poly_field_follower<std::remove_cvref_t<M>, G> follow(m, g, options, "integral_line");
  return follow.line(start);
}

/// Many such lines: auto lines = integral_lines(m, g, starts, {.both_ways = true}).
/// Needs:  as integral_line; starts: a range of verts, polys or mesh_points, iterated over once.
/// Result: a line for each start, in the same order, as integral_line gives it; the same for any number of threads.
/// Cost:   as integral_line, in parallel.
/// Errors: as integral_line; cancelled.
/// Source: as integral_line.
template<class M, class G, class R>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M> && requirement::gives_points<G, poly_t<M>> &&
      requirement::gives_line_starts<M, R>
auto integral_lines(M&& m, const G& g, const R& starts, const integral_line_options& options = {}) {
  const core::profiled_options profiled(options, "integral_lines");
  const detail::poly_field_follower<std::remove_cvref_t<M>, G> follow(m, g, *profiled, "integral_lines");
  return follow.lines(starts);
}

// What to write instead of calls that cannot compile.
template<class... T> void integral_line(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void integral_line(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void integral_line(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void integral_lines(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void integral_lines(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void integral_lines(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class M, class G, class R = mistake::remedy<mistake::give_vectors_at_polys>>
  requires(EmbeddedMesh<M> && !requirement::gives_points<G, poly_t<M>>)
void integral_line(M&&, const G&, ...) = delete;  // a vector at each poly: make_poly_map<vec3>(m), or gradient(m, u)
template<class M, class G, class R = mistake::remedy<mistake::give_vectors_at_polys>>
  requires(EmbeddedMesh<M> && !requirement::gives_points<G, poly_t<M>>)
void integral_lines(M&&, const G&, ...) = delete;  // a vector at each poly: make_poly_map<vec3>(m), or gradient(m, u)
template<class M, class G, class S, class R = mistake::remedy<mistake::give_line_start>>
  requires(requirement::is_lvalue_or_view<M>&& EmbeddedMesh<M>&& requirement::gives_points<G, poly_t<M>> &&
           !requirement::is_line_start<M, S> && !std::is_arithmetic_v<S>)
void integral_line(M&&, const G&, const S&, ...) = delete;  // a vert, a poly or a mesh_point: mesh_point<M>{edge_point<M>{e, 0.5}, position}
template<class G> void integral_line(mistake::any_mesh, const G&, mistake::number<mistake::name_the_element>, ...) = delete;  // write poly_id{0}, not 0
template<class G> void integral_lines(mistake::any_mesh, const G&, mistake::number<mistake::name_the_element>, ...) = delete;  // write {poly_id{0}}, not {0}

}  // namespace concino
