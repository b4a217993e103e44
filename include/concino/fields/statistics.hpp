// statistics: the least and the greatest value of a field, its mean, deviation and integral.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/fields/detail/values/value_statistics.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/operators/mass_matrix.hpp>

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace concino {

/// What statistics returns, of the finite values. X is a vert or a poly.
template<class X>
struct field_statistics {
  double min = 0, max = 0;          // 0 if no value is finite
  std::optional<X> min_at, max_at;  // where these are, the first of several; none if no value is finite
  double mean = 0;                  // weighted by areas or volumes
  double deviation = 0;             // the root of the mean of the squares of differences to the mean (standard
                                    // deviation)
  double integral = 0;              // in units of u times area or volume
  std::size_t count = 0;            // of finite values
  std::size_t not_finite = 0;       // how many are infinite or not a number; they are left out
};

namespace detail {

template<class Elements, class U, class WeightOf>
auto gather_statistics(const Elements& elements, const U& u, const WeightOf& weight_of) {
  using element = std::remove_cvref_t<decltype(*elements.begin())>;
  std::vector<element> all;
  std::vector<double> values, weights;
  for (const element x : elements) {
    all.push_back(x);
    values.push_back(static_cast<double>(u[x]));
    weights.push_back(weight_of(x));
  }
  const value_statistics s = statistics_of_values(values, weights);
  field_statistics<element> result;
  result.not_finite = s.not_finite;
  result.count = values.size() - s.not_finite;
  if (!s.has_values) return result;
  result.min = values[s.min_at], result.max = values[s.max_at];
  result.min_at = all[s.min_at], result.max_at = all[s.max_at];
  result.mean = s.mean, result.deviation = s.deviation, result.integral = s.integral;
  return result;
}

}  // namespace detail

/// The extremes, mean, standard deviation and integral of a function of verts, or of polys if it is none of verts. A
/// poly counts by its measure, a vert by its mass: the share of it in the measures around, as vert_masses.
/// Needs:  EmbeddedMesh; u[v] is a number for each vert, or u[p] for each poly.
/// Result: see field_statistics. If all weights are 0, each value counts alike, and the integral is 0. Large constants
///         lose no digits.
/// Cost:   O(size of the polys) time, O(V) or O(P) memory.
/// Errors: of values at verts those of vert_masses; values that are not finite are counted, not refused.
template<EmbeddedMesh M, class U>
  requires requirement::gives_numbers<U, vert_t<M>>
field_statistics<vert_t<M>> statistics(const M& m, const U& u) {
  const auto mass = vert_masses(m);
  return detail::gather_statistics(verts(m), u, [&](const vert_t<M>& v) { return mass[v]; });
}
template<EmbeddedMesh M, class U>
  requires(requirement::gives_numbers<U, poly_t<M>> && !requirement::gives_numbers<U, vert_t<M>>)
field_statistics<poly_t<M>> statistics(const M& m, const U& u) {
  return detail::gather_statistics(polys(m), u, [&](const poly_t<M>& p) { return std::abs(measure(m, p)); });
}

// What to write instead of calls that cannot compile.
template<class... T> void statistics(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void statistics(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
