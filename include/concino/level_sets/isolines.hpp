// isolines: the curves on a surface where a function of its verts has a value, as polylines.
#pragma once

#include <concino/core/block_allocator.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/parallel.hpp>
#include <concino/level_sets/detail/crossed_edge.hpp>
#include <concino/level_sets/detail/crossed_surface_reader.hpp>
#include <concino/level_sets/detail/level_values.hpp>
#include <concino/level_sets/detail/line_pieces.hpp>
#include <concino/level_sets/detail/simple_lines.hpp>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

namespace concino {

/// One polyline of a level set. If it is closed, the last point is joined to the first one, which is not repeated.
template<class M>
struct level_line {
  std::vector<vec3> points;
  std::vector<mesh_point<M>> places;       // of the points: at a vert, on an edge, or inside a poly, on a diagonal of a poly that is not convex
  std::vector<edge_point<M>> edge_points;  // of the points at verts and on edges, in order; a vert is the end of one of its edges
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

/// Adds the lines of one level set, still without edge_points. locate(places, n, to) writes n points.
template<class M, class Locate>
void add_lines(const level_lines& joined, double level, const Locate& locate, std::vector<level_line<M>>& lines) {
  const std::size_t before = lines.size(), num_lines = joined.ends.size();
  const auto begin_of = [&](std::size_t i) { return i == 0 ? 0 : joined.ends[i - 1]; };
  lines.resize(before + num_lines);
  const std::size_t num_places = num_lines == 0 ? 0 : joined.ends.back();
  constexpr std::size_t many = 50'000;
  parallel_for(  // new memory takes as long as the points: each array is one task; short ones lie in memory that this thread had before
      2 * num_lines,
      [&](std::size_t i) {
        level_line<M>& line = lines[before + i / 2];
        const std::size_t n = joined.ends[i / 2] - begin_of(i / 2);
        if (i % 2 == 0) line.places.resize(n);
        else line.points.resize(n), line.edge_points.reserve(n);
      },
      num_places < many ? 2 * num_lines + 1 : num_lines / 32 + 1);
  for (std::size_t i = 0; i < num_lines; ++i) {
    lines[before + i].closed = joined.closed[i] != 0;
    lines[before + i].value = level;
  }
  constexpr std::size_t chunk = 256;
  parallel_for(
      (num_places + chunk - 1) / chunk,
      [&](std::size_t c) {
        const std::size_t last = std::min(num_places, (c + 1) * chunk);
        std::size_t i = static_cast<std::size_t>(std::upper_bound(joined.ends.begin(), joined.ends.end(), c * chunk) - joined.ends.begin());
        for (std::size_t k = c * chunk; k < last; ++i) {
          level_line<M>& line = lines[before + i];
          const std::size_t first = k - begin_of(i), n = std::min(joined.ends[i], last) - k;
          locate(joined.places.data() + k, n, line.places.data() + first);
          for (std::size_t at = first; at < first + n; ++at) line.points[at] = line.places[at].position;
          k += n;
        }
      },
      1);
}

/// Lists the edge points of all lines from the first one given.
template<class M>
void add_edge_points(const M& m, std::size_t first, std::vector<level_line<M>>& lines) {
  const std::size_t n = lines.size() - first;
  parallel_for(
      n,
      [&](std::size_t i) {
        level_line<M>& line = lines[first + i];
        for (const mesh_point<M>& x : line.places) add_edge_point(m, x, line.edge_points);
      },
      n / 32 + 1);
}

template<class M, class U, class V>
std::vector<level_line<M>> find_isolines(const M& m, const U& u, const V& values, const char* caller) {
  core::thread_team threads(has_many_polys(m));
  std::vector<level_line<M>> lines;
  check_vert_values(m, u, caller);
  const auto levels = sorted_levels(values, caller);
  for (const double& level : levels) {
    const std::size_t num_before = lines.size();
    // One block: new memory in many small pages would take as long as the lines.
    const std::size_t num_verts = vert_index_bound(m);
    const auto block = std::make_shared<core::memory_block>(num_verts + num_verts / 4);
    auto* const states = static_cast<unsigned char*>(block->take(num_verts, 1));
    find_level_states(m, u, level, caller, states);
    auto polys = crossed_polys(m, states);
    simple_lines<M> simple(block);
    if (simple.find(m, states, polys)) {
      const auto locate = [&](const level_place* places, std::size_t n, mesh_point<M>* to) {
        const auto edge_of = [&](std::size_t k) { return simple.edge_of(places[k].element); };
        cross_edges(m, u, level, n, [](std::size_t) { return true; }, edge_of, [to](std::size_t k, const mesh_point<M>& x) { to[k] = x; });
      };
      add_lines(simple.join(), level, locate, lines);
    } else {
      const crossed_surface_reader<M> crossed(m, u, level, std::move(polys));
      const poly_cuts cuts(crossed.arrays, level);
      const auto locate = [&](const level_place* places, std::size_t n, mesh_point<M>* to) {
        for (std::size_t k = 0; k < n; ++k) to[k] = crossed.mesh_point_of(m, places[k], level);
      };
      add_lines(line_pieces(cuts).join(), level, locate, lines);
    }
    if (&level == &levels.back()) threads.finish();  // the helpers end meanwhile, which takes longer than what is left
    add_edge_points(m, num_before, lines);
  }
  return lines;
}

}  // namespace detail

/// The level sets {u = value} of a function that is linear on edges: lines across the polys of a surface.
/// Needs:  Embedded SurfaceMesh; u[v] is a number for each vert, readable from several threads; one value or several.
/// Result: polylines, value after value, ascending, and by their first polys. A line is closed, or ends at the boundary or at an edge with three polys or
///         more; lines through one vert are separate. Larger values are to the left of a line, seen from the side from which its first poly is
///         counter-clockwise. Verts with u = value count as above it. The lines bound {u < value}; where this only touches the boundary of m, or parts of
///         polys without larger values, there is none. They are straight in convex polys; other polys are crossed triangle by triangle of
///         triangulate_polygon. Points and parameters do not depend on the order of adj_e2v. Infinite values are limits of finite ones.
/// Cost:   O(verts + polys) a value, in parallel, and O(n log n) for lines of n points.
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
