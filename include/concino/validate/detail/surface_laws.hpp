// The laws of SurfaceMesh (SM1 .. SM7).
#pragma once

#include <concino/core/message.hpp>
#include <concino/validate/detail/mesh_laws.hpp>

namespace concino::detail {

template<SurfaceMesh M>
void check_surface_mesh(const M& m, const graph_tables<vert_t<M>>& primal, const graph_tables<poly_t<M>>& dual,
                        law_log& log) {
  const auto& vs = primal.nodes;
  const auto& ps = dual.nodes;
  const edge_tables<M> edge = check_edges(m, primal, log);
  const auto& es = edge.edges;

  const adjacency_lists p2v = read_adjacency(m, ps, vs, adj_p2v, "SM3", "adj_p2v", log);
  const adjacency_lists p2e = read_adjacency(m, ps, es, listed_p2e{}, "SM3", "adj_p2e", log);
  check_cycles(ps, vs, es, p2v, p2e, edge.e2v, "SM3", "adj_p2v", "adj_p2e", log);

  const adjacency_lists e2p = read_adjacency(m, es, ps, adj_e2p, "SM4", "adj_e2p", log);
  check_mirror(es, ps, e2p, p2e, "SM4", "adj_e2p", "adj_p2e", log);
  check_mirror(vs, ps, read_adjacency(m, vs, ps, adj_v2p, "SM4", "adj_v2p", log), p2v, "SM4", "adj_v2p", "adj_p2v",
               log);

  check_neighbours(ps, es, dual.next, p2e, e2p, "SM5", log);

  if constexpr (arity_v<M> > 0) {  // law SM6 needs a fixed number of verts
    for (order_index p = 0; p < ps.size() && !log.full("SM6"); ++p)
      if (p2v[p].size() != static_cast<std::size_t>(arity_v<M>) && vs.is_complete)
        log.add("SM6",
                core::joined({"adj_p2v(", ps.name(p), ") has ", p2v[p].size(), " verts, but the arity of the type is ",
                              arity_v<M>}),
                ps.name(p));
  }
  if constexpr (!lists_edges_unordered<M>)
    check_edges_in_order(
        ps, vs, es, p2v, p2e, edge.e2v,
        [](std::size_t k, std::size_t n) { return std::pair(k, k + 1 == n ? 0 : k + 1); }, "SM7", "adj_p2e", "adj_p2v",
        log);
}

}  // namespace concino::detail
