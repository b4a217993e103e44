// persistence: pairs of extrema and saddles of a function on the verts of a graph, by which large hills are told from
// small ones.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/fields/detail/topology/extremum_pairs.hpp>

#include <optional>
#include <vector>

namespace concino {

/// An extremum, the saddle with which it is paired, and the difference of their values.
template<class V>
struct persistence_pair {
  V extremum;
  std::optional<V> saddle;  // none for the lowest minimum and the highest maximum of each component
  double persistence = 0;   // in units of u, 0 or more; infinite without a saddle
};

/// The pairs of a function, those of large persistence first.
template<class V>
struct persistence_pairs {
  std::vector<persistence_pair<V>> minima, maxima;
};

namespace detail {

template<class V>
void name_pairs(const ranked_graph& g, const std::vector<V>& verts, bool of_maxima,
                std::vector<persistence_pair<V>>& to) {
  const std::vector<extremum_pair> pairs = find_extremum_pairs(g, of_maxima);
  to.reserve(pairs.size());
  for (const extremum_pair& p : pairs)
    to.push_back(
        {verts[p.extremum], p.saddle == no_rank ? std::nullopt : std::optional<V>(verts[p.saddle]), p.persistence});
}

}  // namespace detail

/// The persistent homology of dimension 0 of u and of -u. As t grows, components of {u <= t} begin at minima, and join
/// at saddles. Where two join, the one whose minimum is higher ends: this minimum is paired with the saddle. Maxima are
/// paired in the same way, from above.
/// Needs:  PrimalGraph; u[v] is a finite number for each vert, readable from several threads.
/// Result: each minimum and each maximum in one pair. The lowest minimum and the highest maximum of each component have
///         no saddle and infinite persistence. Of verts with equal values, the one with the smaller index counts as the
///         lower one, so some pairs have persistence 0. Pairs come by falling persistence, of equal ones those of lower
///         minima and of higher maxima first. A vert is the saddle of several pairs where more than two components
///         join.
/// Cost:   O(V log V + E) time, up to an inverse Ackermann factor, and O(V + E) memory.
/// Errors: invalid_argument that names a vert whose value is not finite.
/// Source: Edelsbrunner, Letscher, Zomorodian 2002, "Topological persistence and simplification".
template<PrimalGraph M, class U>
  requires requirement::gives_numbers<U, vert_t<M>>
persistence_pairs<vert_t<M>> persistence(const M& m, const U& u) {
  const detail::sorted_verts<M> sorted(m, u, "persistence");
  const detail::ranked_graph g = detail::make_ranked_graph(m, sorted);
  persistence_pairs<vert_t<M>> result;
  detail::name_pairs(g, sorted.verts, false, result.minima);
  detail::name_pairs(g, sorted.verts, true, result.maxima);
  return result;
}

// What to write instead of calls that cannot compile.
template<class... T> void persistence(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class M, class U, class R = mistake::remedy<mistake::give_numbers_at_verts>>
  requires(PrimalGraph<M> && !requirement::gives_numbers<U, vert_t<M>>)
void persistence(const M&, const U&, ...) = delete;  // a number at each vert: make_vert_map<double>(m)

}  // namespace concino
