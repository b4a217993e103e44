// isolines: the curves on a surface where a function of its verts has a value, as polylines.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/level_sets/detail/cut/crossed_surface_reader.hpp>
#include <concino/level_sets/detail/cut/level_states.hpp>
#include <concino/level_sets/detail/lines/line_pieces.hpp>

#include <cstddef>
#include <initializer_list>
#include <variant>
#include <vector>

namespace concino {

/// One polyline of a level set. If it is closed, the last point is joined to the first one, which is not repeated.
template<class M>
struct level_line {
  std::vector<vec3> points;
  std::vector<mesh_point<M>> places;       // of the points: at a vert, on an edge, or inside a poly, on a diagonal of a
                                           // poly that is not convex
  std::vector<edge_point<M>> edge_points;  // of the points at verts and on edges, in order; a vert is the end of one of
                                           // its edges
  bool closed = false;
  double value = 0;                        // of the level set
};

namespace detail {

template<class M>
void add_edge_point(const M& m, const mesh_point<M>& x, std::vector<edge_point<M>>& to) {
  if (const auto* on_edge = std::get_if<edge_point<M>>(&x.element)) to.push_back(*on_edge);
  else if (const auto* vert = std::get_if<vert_t<M>>(&x.element))
    for (const edge_t<M> e : adj_v2e(m, *vert)) {
      to.push_back({e, end_verts(m, e).first == *vert ? 0.0 : 1.0});
      break;
    }
}

template<class M, class U, class V>
std::vector<level_line<M>> find_isolines(const M& m, const U& u, const V& values, const char* caller) {
  std::vector<level_line<M>> lines;
  check_vert_values(m, u, caller);
  for (const double level : sorted_levels(values, caller)) {
    const crossed_surface_reader<M> crossed(m, u, level, crossed_polys(m, level_states(m, u, level, caller)));
    const poly_cuts cuts(crossed.arrays, level);
    const level_lines joined = line_pieces(cuts).join();
    std::size_t k = 0;
    for (std::size_t i = 0; i < joined.ends.size(); ++i) {
      level_line<M>& line = lines.emplace_back();
      line.closed = joined.closed[i] != 0;
      line.value = level;
      const std::size_t n = joined.ends[i] - k;
      line.points.reserve(n), line.places.reserve(n), line.edge_points.reserve(n);
      for (; k < joined.ends[i]; ++k) {
        const mesh_point<M> x = crossed.mesh_point_of(m, joined.places[k], level);
        line.points.push_back(x.position);
        line.places.push_back(x);
        add_edge_point(m, x, line.edge_points);
      }
    }
  }
  return lines;
}

}  // namespace detail

/// The level sets {u = value} of a function that is linear on edges: lines across the polys of a surface.
/// Needs:  Embedded SurfaceMesh; u[v] is a number for each vert, readable from several threads; one value or several.
/// Result: polylines, value after value, ascending, and by their first polys. A line is closed, or ends at the boundary
///         or at an edge with three polys or more; lines through one vert are separate. Larger values are to the left
///         of a line, seen from the side from which its first poly is counter-clockwise. Verts with u = value count as
///         above it. The lines bound {u < value}; where this only touches the boundary of m, or parts of polys without
///         larger values, there is none. They are straight in convex polys; other polys are crossed triangle by
///         triangle of triangulate_polygon. Points and parameters do not depend on the order of adj_e2v. Infinite
///         values are limits of finite ones.
/// Cost:   O(verts + polys) a value, and O(n log n) for lines of n points. The polys that are crossed are found in
///         parallel.
/// Errors: invalid_argument if a value is NaN, naming the vert, or if u is a map of another mesh.
/// Source: paper section 2.2, "Fields".
template<SurfaceMesh M, class U, class V = std::initializer_list<double>>
  requires Embedded<M> && requirement::gives_numbers<U, vert_t<M>> && requirement::is_value_list<V>
std::vector<level_line<M>> isolines(const M& m, const U& u, const V& values) {
  return detail::find_isolines(m, u, values, "isolines");
}

// What to write instead of calls that cannot compile.
template<class... T> void isolines(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void isolines(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class M, class U, class R = mistake::remedy<mistake::give_numbers_at_verts>>
  requires(SurfaceMesh<M> && Embedded<M> && !requirement::gives_numbers<U, vert_t<M>>)
void isolines(M&&, const U&, ...) = delete;  // a number at each vert: make_vert_map<double>(m)

}  // namespace concino
