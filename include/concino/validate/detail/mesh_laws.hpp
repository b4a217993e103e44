// The laws that surfaces and volumes share: edges (SM1, SM2), vert cycles of polygons, and polys that share a facet.
#pragma once

#include <concino/core/message.hpp>
#include <concino/validate/detail/graph_laws.hpp>

#include <cstdint>

namespace concino::detail {

template<class M>
struct edge_tables {
  element_table<edge_t<M>> edges;
  adjacency_lists e2v, v2e;
};

template<AnyMesh M>
edge_tables<M> check_edges(const M& m, const graph_tables<vert_t<M>>& primal, law_log& log) {
  const auto& vs = primal.nodes;
  edge_tables<M> t{read_elements<edge_t<M>>(m, 'e', edges, num_edges, edge_index_bound, "SM1", "SM1", log), {}, {}};
  t.e2v = read_adjacency(m, t.edges, vs, adj_e2v, "SM2", "adj_e2v", log);
  t.v2e = read_adjacency(m, vs, t.edges, adj_v2e, "SM2", "adj_v2e", log);
  for (order_index e = 0; e < t.edges.size() && !log.full("SM2"); ++e)
    if (t.e2v[e].size() != 2 && vs.is_complete)
      log.add("SM2", core::joined({"adj_e2v(", t.edges.name(e), ") is not two different verts"}), t.edges.name(e));
  check_mirror(t.edges, vs, t.e2v, t.v2e, "SM2", "adj_e2v", "adj_v2e", log);
  adjacency_lists far;
  for (order_index v = 0; v < vs.size(); ++v) {
    for (const order_index e : t.v2e[v]) {
      const auto ends = t.e2v[e];
      if (ends.size() == 2 && (ends[0] == v || ends[1] == v)) far.items.push_back(ends[0] == v ? ends[1] : ends[0]);
    }
    far.close();
  }
  check_same(vs, vs, primal.next, far, "SM2", "adj_v2v", "the other end of an edge of adj_v2e", log);
  return t;
}

/// How a polygon traverses one of its edges: in the direction of adj_e2v, in the opposite one, or not at all.
enum class sense : std::uint8_t { along, against, inconsistent };

/// Checks that each polygon's verts, in their order, follow its edges and meet each edge once. Returns the sense of
/// each entry of `edges_of`.
template<class A, class V, class E>
std::vector<sense> check_cycles(const element_table<A>& polygons, const element_table<V>& vs,
                                const element_table<E>& es, const adjacency_lists& verts_of,
                                const adjacency_lists& edges_of, const adjacency_lists& e2v, const char* law,
                                const char* a2v, const char* a2e, law_log& log) {
  std::vector<sense> senses(edges_of.items.size(), sense::inconsistent);
  std::vector<order_index> at(vs.items.size()), owner(vs.items.size(), no_order_index),
      walked(vs.items.size(), no_order_index);
  for (order_index a = 0; a < polygons.size(); ++a) {
    const auto ring = verts_of[a];
    const auto n = static_cast<order_index>(ring.size());
    for (order_index i = 0; i < n; ++i) {
      at[ring[i]] = i;
      owner[ring[i]] = a;
    }
    const std::string args = core::joined({"(", polygons.name(a), ")"});
    if (edges_of[a].size() != n && vs.is_complete && es.is_complete)
      log.add(
          law,
          core::joined({a2e, args, " has ", edges_of[a].size(), " edges, but ", a2v, args, " has ", n, " verts"}),
          polygons.name(a));
    for (std::size_t k = edges_of.offsets[a]; k < edges_of.offsets[a + std::size_t{1}]; ++k) {
      const order_index e = edges_of.items[k];
      const auto ends = e2v[e];
      if (ends.size() != 2) continue;  // reported at the edge
      bool in_cycle = false;
      if (owner[ends[0]] == a && owner[ends[1]] == a) {
        const order_index i = at[ends[0]], j = at[ends[1]];
        const bool along = (i + 1) % n == j, against = (j + 1) % n == i;
        // Each step of the cycle takes one edge; a polygon of two verts has two steps with the same ends.
        if (along && walked[ends[0]] != a) {
          walked[ends[0]] = a;
          senses[k] = sense::along;
          in_cycle = true;
        } else if (against && walked[ends[1]] != a) {
          walked[ends[1]] = a;
          senses[k] = sense::against;
          in_cycle = true;
        }
      }
      if (!in_cycle && vs.is_complete)
        log.add(law,
                core::joined({a2e, args, " holds ", es.name(e), ", whose ends are not consecutive in ", a2v, args}),
                core::joined({polygons.name(a), " ", es.name(e)}));
    }
    for (order_index i = 0; i < n && es.is_complete; ++i)
      if (walked[ring[i]] != a) {
        const std::string here = vs.name(ring[i]), next = vs.name(ring[(i + 1) % n]);
        log.add(
            law,
            core::joined({a2v, args, " goes from ", here, " to ", next, ", but no edge of ", a2e, args, " joins them"}),
            core::joined({polygons.name(a), " ", here, " ", next}));
      }
  }
  return senses;
}

/// Checks that adj_p2p(p) are the polys that share a facet with p. Stops at the first difference of each p. So a facet
/// that claims every poly costs no more than the size of the adjacencies read.
template<class P, class S>
void check_neighbours(const element_table<P>& ps, const element_table<S>& facets, const adjacency_lists& p2p,
                      const adjacency_lists& p2s, const adjacency_lists& s2p, const char* law, law_log& log) {
  std::vector<order_index> listed(ps.items.size(), no_order_index), expected(ps.items.size(), no_order_index);
  const std::string a_facet = facets.kind() == "edge" ? "an edge" : "a face";
  for (order_index p = 0; p < ps.size() && !log.full(law); ++p) {
    for (const order_index q : p2p[p]) listed[q] = p;
    bool good = true;
    for (const order_index s : p2s[p])
      for (const order_index q : s2p[s]) {
        if (!good) break;
        if (q == p) continue;
        expected[q] = p;
        good = listed[q] == p;
        if (!good)
          log.add(law,
                  core::joined(
                      {"adj_p2p(", ps.name(p), ") lacks ", ps.name(q), ", which shares ", facets.name(s), " with it"}),
                  core::joined({ps.name(p), " ", ps.name(q), " ", facets.name(s)}));
      }
    for (const order_index q : p2p[p]) {
      if (good && q != p && expected[q] != p) {
        good = false;
        log.add(law,
                core::joined({"adj_p2p(", ps.name(p), ") holds ", ps.name(q), ", but they do not share ", a_facet}),
                core::joined({ps.name(p), " ", ps.name(q)}));
      }
    }
  }
}

/// What the traits list, before the verbs sort it: the law applies to this list.
struct listed_p2e {
  template<class M> decltype(auto) operator()(const M& m, const poly_t<M>& p) const { return traits<M>::adj_p2e(m, p); }
};
struct listed_f2e {
  template<class M> decltype(auto) operator()(const M& m, const face_t<M>& f) const { return traits<M>::adj_f2e(m, f); }
};

/// Checks that the k-th edge of a poly or face of n verts joins the verts numbered ends_of(k, n).
template<class P, class V, class E, class Ends>
void check_edges_in_order(const element_table<P>& ps, const element_table<V>& vs, const element_table<E>& es,
                          const adjacency_lists& p2v, const adjacency_lists& p2e, const adjacency_lists& e2v,
                          const Ends& ends_of, const char* law, const char* edge_verb, const char* vert_verb,
                          law_log& log) {
  for (order_index p = 0; p < ps.size() && !log.full(law); ++p) {
    const auto corners = p2v[p], edges = p2e[p];
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const auto [i, j] = ends_of(k, corners.size());
      const auto ends = e2v[edges[k]];
      if (i >= corners.size() || j >= corners.size() || ends.size() != 2) continue;  // reported elsewhere
      const order_index a = corners[i], b = corners[j];
      if ((ends[0] == a && ends[1] == b) || (ends[0] == b && ends[1] == a)) continue;
      const std::string arg = core::joined({"(", ps.name(p), ")"});
      log.add(law,
              core::joined(
                  {edge_verb, arg, " has ", es.name(edges[k]), " where the edge from ", vs.name(a), " to ", vs.name(b),
                   " of ", vert_verb, arg,
                   " should be; sort the list, or write static constexpr bool edges_in_order = false; in mesh_traits"}),
              core::joined({ps.name(p), " ", es.name(edges[k])}));
    }
  }
}

}  // namespace concino::detail
