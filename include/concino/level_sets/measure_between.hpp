// measure_between: how much of a mesh lies between two values of a function.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/core/poly_chunks.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/level_sets/detail/clip/measure_parts.hpp>
#include <concino/level_sets/detail/cut/crossed_surface_reader.hpp>
#include <concino/level_sets/detail/cut/crossed_volume_reader.hpp>
#include <concino/level_sets/detail/cut/level_states.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace concino {

namespace detail {

/// The measures of {u >= level} in polys that are cut.
template<class M, class U>
double cut_measure_of(const M& m, const U& u, double level, std::vector<poly_t<M>> crossed) {
  if constexpr (dimension_v<M> == 2) {  // polygons are cut by chords, polyhedra by caps
    const crossed_surface_reader<M> reader(m, u, level, std::move(crossed));
    poly_cuts cuts(reader.arrays, level);
    return area_above(poly_parts(cuts), reader.arrays, level);
  } else {
    constexpr auto surface = arity_v<M> > 0 ? cell_cuts::cells_are::spheres : cell_cuts::cells_are::unknown;
    const crossed_volume_reader<M> reader(m, u, level, std::move(crossed));
    cell_cuts cuts(reader.arrays, surface, "measure_between", reader.poly_indices);
    return volume_above(cell_parts(cuts), reader.arrays);
  }
}
/// The same, in parallel: where polys are cut does not depend on others, and caps of neighbours that coincide have
/// opposite signs. A few polys at a time need little memory.
template<class M, class U>
double cut_measure_above(const M& m, const U& u, double level, const std::vector<poly_t<M>>& crossed) {
  constexpr std::size_t chunk = 256;
  std::vector<double> above(crossed.size() / chunk + (crossed.size() % chunk != 0));
  parallel_for(
      above.size(),
      [&](std::size_t i) {
        const poly_t<M>* const first = crossed.data() + i * chunk;
        above[i] = cut_measure_of(m, u, level, {first, first + std::min(chunk, crossed.size() - i * chunk)});
      },
      1);
  return std::accumulate(above.begin(), above.end(), 0.0);
}

/// By index of a vert: how many of the levels, which ascend, are not above its value.
template<class M, class U>
std::vector<std::uint32_t> level_ranks(const M& m, const U& u, const std::vector<double>& levels, const char* caller) {
  std::vector<std::uint32_t> ranks(vert_index_bound(m));
  parallel_for_each(verts(m), [&](const vert_t<M>& v) {
    const double x = static_cast<double>(u[v]);
    if (std::isnan(x)) throw_value_is_nan(caller, index_of(m, v));
    ranks[index_of(m, v)] =
        static_cast<std::uint32_t>(std::upper_bound(levels.begin(), levels.end(), x) - levels.begin());
  });
  return ranks;
}

/// The levels with these numbers cross a poly.
struct crossing_levels { std::uint32_t first, last; };
template<class M>
crossing_levels crossing_levels_of(const M& m, const std::vector<std::uint32_t>& ranks, const poly_t<M>& p) {
  crossing_levels x{~0u, 0};
  for (const vert_t<M> v : adj_p2v(m, p)) {
    const std::uint32_t rank = ranks[index_of(m, v)];
    x.first = std::min(x.first, rank), x.last = std::max(x.last, rank);
  }
  return x;
}

}  // namespace detail

/// The area of a surface, or the volume of a volume, between consecutive values of a function of its verts.
/// Needs:  EmbeddedMesh; u[v] is a number for each vert; two values or more, which are sorted.
/// Result: of the values a, b, c: the measures of {a <= u < b} and {b <= u <= c}; equal values count once. They are
///         differences of the measures of clip(m, u, a), clip(m, u, b) ... On triangles and tets they are continuous in
///         the values; on other polys they may jump where a value passes that of a vert, or the mean of the values at a
///         face. Units of measure(m, p).
/// Cost:   O(verts + polys), and O(n) for n polys that are cut, at each value by which they are cut; in parallel.
/// Errors: invalid_argument if a value is NaN, naming the vert, if u is a map of another mesh, or if there are fewer
///         than two values. unsupported as isosurface.
template<EmbeddedMesh M, class U, class V = std::initializer_list<double>>
  requires requirement::gives_numbers<U, vert_t<M>> && requirement::is_value_list<V>
std::vector<double> measure_between(const M& m, const U& u, const V& values) {
  detail::check_vert_values(m, u, "measure_between");
  std::vector<double> levels = detail::sorted_levels(values, "measure_between");
  if (levels.size() < 2) throw invalid_argument("measure_between: there must be two different values or more");
  // the last interval is closed
  levels.back() = std::nextafter(levels.back(), std::numeric_limits<double>::infinity());
  std::vector<double> between(levels.size() - 1);
  const auto ranks = detail::level_ranks(m, u, levels, "measure_between");
  struct chunk_result {
    std::vector<std::pair<std::size_t, double>> whole;  // an interval, and what is between it and the last level
    std::vector<poly_t<M>> crossed;
  };
  const auto parts = core::poly_chunks<M>(m).template results<chunk_result>([&](chunk_result& x, const poly_t<M>& p) {
    const auto [first, last] = detail::crossing_levels_of(m, ranks, p);
    if (first < last) x.crossed.push_back(p);
    if (first == 0 || first > between.size()) return;
    if (x.whole.empty() || x.whole.back().first != first - 1) x.whole.emplace_back(first - 1, 0);
    x.whole.back().second += measure(m, p);
  });
  std::vector<std::vector<poly_t<M>>> crossed(levels.size());
  for (const chunk_result& x : parts) {
    for (const auto& [interval, whole] : x.whole) between[interval] += whole;
    for (const poly_t<M>& p : x.crossed) {
      const auto [first, last] = detail::crossing_levels_of(m, ranks, p);
      for (std::uint32_t i = first; i < last; ++i) crossed[i].push_back(p);
    }
  }
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const double above = detail::cut_measure_above(m, u, levels[i], crossed[i]);
    if (i < between.size()) between[i] += above;
    if (i > 0) between[i - 1] -= above;
  }
  return between;
}

// What to write instead of calls that cannot compile.
template<class... T> void measure_between(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void measure_between(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class M, class U, class R = mistake::remedy<mistake::give_numbers_at_verts>>
  requires(EmbeddedMesh<M> && !requirement::gives_numbers<U, vert_t<M>>)
void measure_between(M&&, const U&, ...) = delete;  // a number at each vert: make_vert_map<double>(m)

}  // namespace concino
