// make_tubes: round tubes along polylines, such as paths, iso-lines, integral lines and geodesics.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/render/detail/shapes/flat_lines.hpp>
#include <concino/render/drawable.hpp>

#include <initializer_list>
#include <optional>
#include <span>

namespace concino {

struct tube_options {
  double radius = 0;                         // in units of the mesh, 0 or more; 0: 0.4 % of the diagonal of the
                                             // bounding box of all points
  rgb color = srgb(0.84f, 0.13f, 0.14f);     // if there are no values
  std::span<const double> values = {};       // one for each point, line after line, or one for each line: the tubes
                                             // have the colours of `map`
  std::span<const double> radii = {};        // one for each point, line after line, instead of `radius`: each above 0
  colormap map = colormap::blue_to_yellow;   // of the values
  std::optional<value_scale> scale = {};     // from values to positions in the map, such as that of a mesh; empty:
                                             // linear over the finite values
  double opacity = 1;                        // in [0, 1]
  bool closed = false;                       // joins the last point of each line to its first. Lines with a member
                                             // `closed` are drawn as it says
  int corners = 0;                           // of the cross-section, 3 to 256; 0: 12 for up to 4,000 points, 8 for up
                                             // to 40,000, 6 for more
  double tolerance = 0.03;                   // 0 or more, in radii: points are left out where the line without them is
                                             // so close; 0: no point is
};

namespace detail {

drawable tubes_along(const flat_lines& lines, const tube_options& options, const char* caller);

}  // namespace detail

/// Tubes along polylines, with round joints and round ends: cn::make_tubes(cn::isolines(m, u, {0.5}), {.radius =
/// 0.01}).
/// Needs:  lines: a polyline or a range of polylines. A polyline is a range of points p with p[0], p[1], p[2] or with
///         such a p.position, or an object with such a range as its member `points`, as the results of isolines,
///         integral_line and trace_geodesic.
/// Result: a drawable with smooth normals. `polys` has the number of the line of each polygon. Each tube is closed and
///         oriented outward, and its points are at the radius from a point of its line; where a line turns by more than
///         25 degrees, they form a part of a ball. The cross-section is not twisted, and on closed lines the same after
///         each turn. Points that repeat the point before are left out; a line of one point is a ball, a line without
///         points nothing. Values that are not finite have the colour look.no_value.
/// Cost:   about 130 bytes for each corner of a cross-section, at each point of the lines that is not left out, and a
///         few for each line end; O(points).
/// Errors: invalid_argument if a point is not finite, naming it and its line; if an option is out of its range; if
///         there are values or radii, but not as many as the options say. unsupported if there are too many points for
///         32-bit numbers.
/// Source: frames without twist: Bishop 1975, "There is more than one way to frame a curve".
template<class L = std::initializer_list<vec3>>
  requires requirement::is_lines<L>
drawable make_tubes(const L& lines, const tube_options& options = {}) {
  detail::flat_lines flat;
  if constexpr (requirement::is_polyline<L>) flat.add(lines, options.closed);
  else
    for (const auto& line : lines) flat.add(line, options.closed);
  return detail::tubes_along(flat, options, "make_tubes");
}

/// Tubes along walks on a mesh: cn::make_tubes(m, cn::shortest_path(m, a, b)).
/// Needs:  Embedded M with verts, or an EmbeddedMesh for polys. walks: one or a range of them. A walk is a range of
///         verts, or of polys, whose centroids are joined, or an object with a range of verts as its member `verts`, as
///         the edge_walks of boundary_loops.
/// Result: as above; an edge_walk is drawn closed if it is.
/// Cost:   as above.      Errors: as above.
template<Embedded M, class W>
  requires(requirement::is_walk<W, M> || requirement::is_walk_range<W, M>)
drawable make_tubes(const M& m, const W& walks, const tube_options& options = {}) {
  detail::flat_lines flat;
  if constexpr (requirement::is_walk<W, M>) flat.add(m, walks, options.closed);
  else
    for (const auto& walk : walks) flat.add(m, walk, options.closed);
  return detail::tubes_along(flat, options, "make_tubes");
}

// What to write instead of calls that cannot compile.
template<class... T> void make_tubes(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void make_tubes(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/render/detail/shapes/tubes.ipp>
#endif
