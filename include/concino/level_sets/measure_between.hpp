// measure_between: how much of a mesh lies between two values of a function.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/level_sets/detail/crossed_surface_reader.hpp>
#include <concino/level_sets/detail/crossed_volume_reader.hpp>
#include <concino/level_sets/detail/level_values.hpp>
#include <concino/level_sets/detail/measure_parts.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <vector>

namespace concino {

namespace detail {

/// The measures of {u >= level} in polys that are cut.
template<class M, class U>
double cut_measure_above(const M& m, const U& u, double level, std::vector<poly_t<M>> crossed) {
  if (crossed.empty()) return 0;
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

}  // namespace detail

/// The area of a surface, or the volume of a volume, between consecutive values of a function of its verts.
/// Needs:  EmbeddedMesh; u[v] is a number for each vert; two values or more, which are sorted.
/// Result: of the values a, b, c: the measures of {a <= u < b} and {b <= u <= c}; equal values count once. They are differences of the measures of
///         clip(m, u, a), clip(m, u, b) ... On triangles and tets they are continuous in the values; on other polys they may jump where a value passes
///         that of a vert, or the mean of the values at a face. Units of measure(m, p).
/// Cost:   O(verts + polys), and O(n log n) for n polys that are cut, at each value by which they are cut.
/// Errors: invalid_argument if a value is NaN, naming the vert, if u is a map of another mesh, or if there are fewer than two values. unsupported as
///         isosurface.
template<EmbeddedMesh M, class U, class V = std::initializer_list<double>>
  requires requirement::gives_numbers<U, vert_t<M>> && requirement::is_value_list<V>
std::vector<double> measure_between(const M& m, const U& u, const V& values) {
  detail::check_vert_values(m, u, "measure_between");
  std::vector<double> levels = detail::sorted_levels(values, "measure_between");
  if (levels.size() < 2) throw invalid_argument("measure_between: there must be two different values or more");
  levels.back() = std::nextafter(levels.back(), std::numeric_limits<double>::infinity());  // the last interval is closed
  std::vector<double> between(levels.size() - 1);
  std::vector<std::vector<poly_t<M>>> crossed(levels.size());
  for (const poly_t<M> p : polys(m)) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const vert_t<M> v : adj_p2v(m, p)) {
      const double x = static_cast<double>(u[v]);
      if (std::isnan(x)) detail::throw_value_is_nan("measure_between", index_of(m, v));
      low = std::min(low, x);
      high = std::max(high, x);
    }
    const auto first = static_cast<std::size_t>(std::upper_bound(levels.begin(), levels.end(), low) - levels.begin());
    if (first > 0 && first <= between.size()) between[first - 1] += measure(m, p);  // all of it is above that level
    for (std::size_t i = first; i < levels.size() && levels[i] <= high; ++i) crossed[i].push_back(p);
  }
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const double above = detail::cut_measure_above(m, u, levels[i], std::move(crossed[i]));
    if (i < between.size()) between[i] += above;
    if (i > 0) between[i - 1] -= above;
  }
  return between;
}

// What to write instead of calls that cannot compile.
template<class... T> void measure_between(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter
template<class... T> void measure_between(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class M, class U, class R = mistake::remedy<mistake::give_numbers_at_verts>>
  requires(EmbeddedMesh<M> && !requirement::gives_numbers<U, vert_t<M>>)
void measure_between(M&&, const U&, ...) = delete;  // a number at each vert: make_vert_map<double>(m)

}  // namespace concino
