// resample: a field of one mesh on another mesh.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/fields/detail/values/conservative_transfer.hpp>
#include <concino/fields/detail/values/value_in_poly.hpp>
#include <concino/geometry/bounding_tree.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/mesh/element_map.hpp>

#include <cmath>
#include <limits>

namespace concino {

enum class vert_resampling {
  linear,   // the value at the closest point, by linear functions on the triangles or tets between a poly's mean point,
            // the mean points of its faces and its edges
  nearest,  // the value of the vert nearest to a point among those of the poly with the closest point
};

enum class poly_resampling {
  conservative,  // by common areas or volumes, such that the integral stays what it is
  nearest,       // the value of the poly closest to the centroid
};

namespace detail {

[[noreturn]] void throw_nothing_to_resample();

template<class From, class U>
double value_of_nearest(const From& from, const poly_t<From>& p, const U& u, const vec3& x) {
  double value = 0, least = std::numeric_limits<double>::infinity();
  for (const vert_t<From> v : adj_p2v(from, p)) {
    const double d = distance(to_vec3(point(from, v)), x);
    if (!(d < least)) continue;
    least = d;
    value = static_cast<double>(u[v]);
  }
  return value;
}

}  // namespace detail

/// The values of u, a function of the verts of one mesh, at the verts of another: those at the points of `from` closest
/// to them.
/// Needs:  EmbeddedMesh both, surfaces or volumes, `to` not a temporary; u[v] is a number for each vert of `from`,
///         readable from several threads.
/// Result: a map of double. Linear functions are exact at points of `from`, on polys of every shape; constants stay
///         what they are; verts at the same points as verts of `from` have their values, if polys are star-shaped about
///         the means of their verts. Verts outside get the value at the closest point, not a continuation. With
///         `nearest`, which of several polys or verts at the same distance is taken depends on the order in which
///         `from` is stored.
/// Cost:   O((P + V) log P) time for P polys of `from` and V verts of `to`, in parallel, O(P) memory.
/// Errors: invalid_argument if `from` has no polys, or a vert of `to` is not finite. invalid_mesh if a vert of `from`
///         is not finite.
template<EmbeddedMesh From, class U, class To>
  requires requirement::is_lvalue_or_view<To> && EmbeddedMesh<To> && requirement::gives_numbers<U, vert_t<From>>
vert_map<To, double> resample(const From& from, const U& u, To&& to, vert_resampling method = vert_resampling::linear) {
  if (num_polys(from) == 0) detail::throw_nothing_to_resample();
  auto result = make_vert_map<double>(to);
  const auto tree = bounding_tree(from);
  parallel_for_each(
      verts(to),
      [&](const vert_t<To>& v) {
        const vec3 x = to_vec3(point(to, v));
        const auto hit = tree.closest(x);
        result[v] = method == vert_resampling::linear ? detail::value_in_poly(from, hit.poly, u, hit.point)
                                                      : detail::value_of_nearest(from, hit.poly, u, x);
      },
      64);
  return result;
}

/// The values of q, a function of the polys of one mesh, on the polys of another.
/// Needs:  EmbeddedMesh both, of the same dimension, `to` not a temporary; q[p] is a number for each poly of `from`,
///         readable from several threads.
/// Result: a map of double. conservative: each poly of `from` is divided among the polys of `to` with which it has a
///         part in common, so that the integral, the sum of values times measures, is kept to rounding. Where both
///         meshes cover the same domain, values are exact means, and constants stay. A poly that is partly outside of
///         `to` gives all to the polys that it meets, and one that meets none to the poly closest to its centroid. On
///         surfaces, polys are projected to the planes of those of `to` near to them that face the same side. nearest:
///         values are copied; which of several polys at the same distance is taken depends on the order in which `from`
///         is stored.
/// Cost:   O(P log P) time, and that of cutting simplices by each other for each pair of polys that meet: some
///         microseconds for triangles and tets, a hundred times more for hexes. In parallel.
/// Errors: invalid_argument if `from` has polys and `to` has none, or `from` has none and `to` has some. invalid_mesh
///         if a vert of a poly is not finite, or naming a poly of `to` without measure that would get a part.
/// Source: Farrell, Piggott, Pain, Gorman, Wilson 2009, "Conservative interpolation between unstructured meshes via
///         supermesh construction".
template<EmbeddedMesh From, class Q, class To>
  requires(requirement::is_lvalue_or_view<To>&& EmbeddedMesh<To>&& dimension_v<From> == dimension_v<To> &&
           requirement::gives_numbers<Q, poly_t<From>> && !requirement::gives_numbers<Q, vert_t<From>>)
poly_map<To, double> resample(const From& from, const Q& q, To&& to,
                              poly_resampling method = poly_resampling::conservative) {
  auto result = make_poly_map<double>(to);
  if ((num_polys(from) == 0) != (num_polys(to) == 0)) detail::throw_nothing_to_resample();
  if (num_polys(to) == 0) return result;
  if (method == poly_resampling::conservative) {
    detail::transfer_conservatively(from, q, to, result);
    return result;
  }
  const auto tree = bounding_tree(from);
  parallel_for_each(
      polys(to), [&](const poly_t<To>& p) { result[p] = static_cast<double>(q[tree.closest(centroid(to, p)).poly]); },
      64);
  return result;
}

// What to write instead of calls that cannot compile.
template<class... T> void resample(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class U> void resample(mistake::any_mesh, const U&, mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void resample(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/fields/detail/values/resample.ipp>
#endif
