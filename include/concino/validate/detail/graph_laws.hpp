// The laws of PrimalGraph (PG1 .. PG4) and DualGraph (DG1 .. DG4).
#pragma once

#include <concino/core/message.hpp>
#include <concino/validate/detail/law_tables.hpp>

namespace concino::detail {

/// The tables of a graph, for laws that build on it.
template<class D>
struct graph_tables {
  element_table<D> nodes;
  adjacency_lists next;
};

template<class D>
void check_graph(const graph_tables<D>& g, const char* symmetry, const char* loops, const char* verb, law_log& log) {
  const auto& n = g.nodes;
  compare_sets(
      g.next, transposed(g.next, n.size()), n.size(),
      [&](order_index a, order_index b) {
        log.add(symmetry,
                core::joined({verb, "(", n.name(a), ") holds ", n.name(b), ", but ", verb, "(", n.name(b),
                              ") does not hold ", n.name(a)}),
                core::joined({n.name(a), " ", n.name(b)}));
        return !log.full(symmetry);
      },
      [](order_index, order_index) { return true; });  // symmetric pair
  for (order_index a = 0; a < g.next.size() && !log.full(loops); ++a)
    for (const order_index b : g.next[a])
      if (a == b)
        log.add(loops, core::joined({verb, "(", g.nodes.name(a), ") holds ", g.nodes.name(a), " itself"}),
                g.nodes.name(a));
}

template<PrimalGraph M>
graph_tables<vert_t<M>> check_primal_graph(const M& m, law_log& log) {
  graph_tables<vert_t<M>> g{read_elements<vert_t<M>>(m, 'v', verts, num_verts, vert_index_bound, "PG1", "PG2", log),
                            {}};
  g.next = read_adjacency(m, g.nodes, g.nodes, adj_v2v, "PG4", "adj_v2v", log);
  check_graph(g, "PG3", "PG4", "adj_v2v", log);
  return g;
}

template<DualGraph M>
graph_tables<poly_t<M>> check_dual_graph(const M& m, law_log& log) {
  graph_tables<poly_t<M>> g{read_elements<poly_t<M>>(m, 'p', polys, num_polys, poly_index_bound, "DG1", "DG2", log),
                            {}};
  g.next = read_adjacency(m, g.nodes, g.nodes, adj_p2p, "DG4", "adj_p2p", log);
  check_graph(g, "DG3", "DG4", "adj_p2p", log);
  return g;
}

}  // namespace concino::detail
