// simplified: a function near to another one, without its small valleys or without its small hills.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/fields/detail/topology/flood.hpp>
#include <concino/mesh/element_map.hpp>

#include <cstdint>
#include <vector>

namespace concino {

struct simplify_options {
  double minima_below = 0;  // minima of less persistence are removed, in units of u, 0 or more; infinite: all but one
                            // in each component
  double maxima_below = 0;  // the same for maxima; one of the two is 0
};

/// A function without the minima whose persistence is less than a threshold. Their valleys are filled up to the saddles
/// with which they are paired. Or without such maxima, by cutting hills off.
/// Needs:  PrimalGraph, not a temporary; u[v] is a finite number for each vert, readable from several threads.
/// Result: a map of double. Its minima are those of u with at least that persistence, and they keep their values.
///         Values grow, by less than the threshold; those outside of the filled valleys stay. A filled valley rises
///         from its saddle by steps of at most one unit in the last place, so that it has no minimum and ties need no
///         care; verts that are lower than this rise with it. It can have new maxima of such a height. For maxima the
///         same holds upside down. To simplify the result again changes nothing.
/// Cost:   O(V log V + E) time, O(V + E) memory.
/// Errors: invalid_argument that names a vert whose value is not finite, or unless one threshold is above 0 and the
///         other is 0.
/// Source: Edelsbrunner, Morozov, Pascucci 2006, "Persistence-sensitive simplification of functions on 2-manifolds";
///         flooding by a queue as Barnes, Lehman, Mulla 2014, "Priority-flood: an optimal depression-filling and
///         watershed-labeling algorithm for digital elevation models".
template<class M, class U>
  requires requirement::is_lvalue_or_view<M> && PrimalGraph<M> && requirement::gives_numbers<U, vert_t<M>>
vert_map<M, double> simplified(M&& m, const U& u, const simplify_options& options) {
  using mesh = std::remove_cvref_t<M>;
  detail::check_thresholds(options.minima_below, options.maxima_below);
  const detail::sorted_verts<mesh> sorted(m, u, "simplified");
  const bool of_maxima = options.maxima_below > 0;
  const std::vector<double> values = detail::flooded_values(
      detail::make_ranked_graph(m, sorted), of_maxima ? options.maxima_below : options.minima_below, of_maxima);
  auto result = make_vert_map<double>(m);
  for (std::uint32_t rank = 0; rank < sorted.size(); ++rank) result[sorted.verts[rank]] = values[rank];
  return result;
}

// What to write instead of calls that cannot compile.
template<class... T> void simplified(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void simplified(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class M, class U, class R = mistake::remedy<mistake::give_numbers_at_verts>>
  requires(PrimalGraph<M> && !requirement::gives_numbers<U, vert_t<M>>)
void simplified(M&&, const U&, ...) = delete;  // a number at each vert: make_vert_map<double>(m)

}  // namespace concino
