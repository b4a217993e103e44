// to_verts: values at verts from values at polys, as level sets and other functions of verts need them.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh/element_map.hpp>

#include <cmath>
#include <type_traits>

namespace concino {

/// Values at the verts of a mesh from values at its polys: the mean over the polys at each vert, weighted by their
/// measures.
/// Needs:  EmbeddedMesh, not a temporary; q[p] is a number for each poly.
/// Result: a map of double. Constants stay what they are. Where the measures of all polys at a vert are 0, the mean is
///         not weighted; a vert without polys has the value 0.
/// Cost:   O(elements).
/// Errors: none; a value or a point that is not a number makes those of the verts around it not a number, which level
///         sets refuse.
template<class M, class Q>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M> && requirement::gives_numbers<Q, poly_t<M>>
vert_map<M, double> to_verts(M&& m, const Q& q) {
  using mesh = std::remove_cvref_t<M>;
  auto values = make_vert_map<double>(m);
  auto size = make_poly_map<double>(m);
  for (const poly_t<mesh> p : polys(m)) size[p] = std::abs(measure(m, p));
  for (const vert_t<mesh> v : verts(m)) {
    double sum = 0, weights = 0, plain = 0, n = 0;
    for (const poly_t<mesh> p : adj_v2p(m, v)) {
      sum += size[p] * static_cast<double>(q[p]);
      weights += size[p];
      plain += static_cast<double>(q[p]);
      ++n;
    }
    if (n > 0) values[v] = weights != 0 ? sum / weights : plain / n;
  }
  return values;
}

// What to write instead of calls that cannot compile.
template<class... T> void to_verts(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void to_verts(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
