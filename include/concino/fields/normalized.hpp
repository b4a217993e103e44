// normalized: values moved into a range, and vectors made unit vectors.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/core/error.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/parallel.hpp>
#include <concino/core/vec3.hpp>
#include <concino/mesh/element_map.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace concino {

struct normalize_options {
  double low = 0;   // what the least value becomes, finite
  double high = 1;  // what the greatest value becomes, finite; it may be less than low
};

namespace detail {

void check_range(const normalize_options& options);

struct finite_range {
  double min = std::numeric_limits<double>::infinity(), max = -min;

  void add(double x) {
    if (!std::isfinite(x)) return;
    min = std::min(min, x);
    max = std::max(max, x);
  }
  /// Halves, since differences of the largest doubles overflow.
  double in(const normalize_options& o, double x) const {
    if (!(max > min)) return std::isfinite(x) ? o.low : x;
    const double t = (x / 2 - min / 2) / (max / 2 - min / 2);
    return (1 - t) * o.low + t * o.high;
  }
};

template<class Result, class Elements, class U>
void normalize_values(const Elements& elements, const U& u, const normalize_options& options, Result& result) {
  check_range(options);
  finite_range range;
  for (const auto& x : elements) range.add(static_cast<double>(u[x]));
  for (const auto& x : elements) result[x] = range.in(options, static_cast<double>(u[x]));
}

}  // namespace detail

/// The values of verts, or of polys, moved and scaled such that the least one becomes options.low and the greatest one
/// options.high; and the vectors of polys divided by their lengths.
/// Needs:  AnyMesh, or for values at verts PrimalGraph, not a temporary; u[v] is a number for each vert, or u[p] a
///         number or a vector for each poly.
/// Result: a map of double or vec3. If all values are equal, they become options.low. The range is that of finite
///         values; other values stay infinite or not numbers. The zero vector stays, and vectors that are not finite
///         become NaN.
/// Cost:   O(elements).
/// Errors: invalid_argument if an end of the range is not finite.
template<class M, class U>
  requires requirement::is_lvalue_or_view<M> && PrimalGraph<M> && requirement::gives_numbers<U, vert_t<M>>
vert_map<M, double> normalized(M&& m, const U& u, const normalize_options& options = {}) {
  auto result = make_vert_map<double>(m);
  detail::normalize_values(verts(m), u, options, result);
  return result;
}
template<class M, class U>
  requires(requirement::is_lvalue_or_view<M>&& AnyMesh<M>&& requirement::gives_numbers<U, poly_t<M>> &&
           !requirement::gives_numbers<U, vert_t<M>>)
poly_map<M, double> normalized(M&& m, const U& u, const normalize_options& options = {}) {
  auto result = make_poly_map<double>(m);
  detail::normalize_values(polys(m), u, options, result);
  return result;
}
template<class M, class Field>
  requires requirement::is_lvalue_or_view<M> && AnyMesh<M> && requirement::gives_points<Field, poly_t<M>>
poly_map<M, vec3> normalized(M&& m, const Field& field) {
  auto result = make_poly_map<vec3>(m);
  parallel_for_each(polys(m), [&](const poly_t<M>& p) {
    const vec3 x = to_vec3(field[p]);
    const double largest = std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)});
    if (x == vec3()) return;
    const vec3 scaled = largest < 1 ? x * 0x1p500 : x * 0x1p-500;  // so that the length neither overflows nor loses
                                                                   // digits
    result[p] = scaled / norm(scaled);
  });
  return result;
}

// What to write instead of calls that cannot compile.
template<class... T> void normalized(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void normalized(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/fields/detail/values/normalized.ipp>
#endif
