// The adjacent verts and edges of every vert: construction, and updates when the mesh is edited.
#pragma once

#include <concino/mesh/detail/alive_elements.hpp>
#include <concino/mesh/detail/jagged_array.hpp>

namespace concino::detail {

/// Fills the neighbours and edges of every vert from the ends of every edge. degrees[v + 1] is the number of edges at v; `next` is scratch memory
/// with one number per vert.
inline void fill_vertex_incidence(offsets degrees, const jagged_array<vert_id, 2>& ends, core::flat_array<std::uint32_t>& next, jagged_array<vert_id, 0>& v2v, jagged_array<edge_id, 0>& v2e) {
  v2v = make_jagged_array<vert_id>(std::move(degrees));
  v2e = {v2v.shared_offsets(), core::flat_array<edge_id>(v2v.num_values())};
  std::copy_n(v2v.shared_offsets()->begin(), next.size(), next.data());
  vert_id* const verts = v2v.begin(0);
  edge_id* const edges = v2e.begin(0);
  for (std::size_t e = 0; e < ends.size(); ++e) {
    const vert_id a = ends.begin(e)[0], b = ends.begin(e)[1];
    const std::uint32_t i = next[a.raw()]++, j = next[b.raw()]++;
    verts[i] = b;
    verts[j] = a;
    edges[i] = edges[j] = edge_id{e};
  }
}

inline edge_id edge_between(const jagged_array<vert_id, 0>& v2v, const jagged_array<edge_id, 0>& v2e, vert_id a, vert_id b) {
  const id_span<vert_id> near = v2v[a.raw()];
  for (std::size_t i = 0; i < near.size(); ++i)
    if (near[i] == b) return v2e[a.raw()][i];
  return {};
}

/// After this call commit_vertex_incidence() cannot fail.
inline void stage_vertex_incidence(jagged_array<vert_id, 0>& v2v, jagged_array<edge_id, 0>& v2e, jagged_array<poly_id, 0>& v2p) {
  v2v.stage_row(nullptr, 0);
  v2e.stage_row(nullptr, 0);
  v2p.stage_row(nullptr, 0);
}

/// Adds the rows that were staged.
inline void commit_vertex_incidence(jagged_array<vert_id, 0>& v2v, jagged_array<edge_id, 0>& v2e, jagged_array<poly_id, 0>& v2p) {
  v2v.commit_row(0);
  v2e.commit_row(0);
  v2p.commit_row(0);
}

/// After this call, n calls of add_edge() cannot fail because of the rows of this end v.
inline void reserve_edges_at(jagged_array<vert_id, 0>& v2v, jagged_array<edge_id, 0>& v2e, vert_id v, std::uint32_t n) {
  if (n == 0) return;
  v2v.reserve_in_row(v.raw(), n);
  v2e.reserve_in_row(v.raw(), n);
}

inline edge_id add_edge(alive_elements<edge_id>& edges, jagged_array<vert_id, 2>& ends, jagged_array<vert_id, 0>& v2v, jagged_array<edge_id, 0>& v2e, vert_id a, vert_id b) {
  const edge_id e = edges.add();
  const vert_id two[] = {std::min(a, b), std::max(a, b)};
  ends.add_row(two, two + 2);
  v2v.push(a.raw(), b);
  v2e.push(a.raw(), e);
  v2v.push(b.raw(), a);
  v2e.push(b.raw(), e);
  return e;
}

/// Both rows of a vert keep their order, so they remain parallel.
inline void remove_edge(alive_elements<edge_id>& edges, const jagged_array<vert_id, 2>& ends, jagged_array<vert_id, 0>& v2v, jagged_array<edge_id, 0>& v2e, edge_id e) {
  const vert_id a = ends[e.raw()][0], b = ends[e.raw()][1];
  v2v.remove(a.raw(), b);
  v2e.remove(a.raw(), e);
  v2v.remove(b.raw(), a);
  v2e.remove(b.raw(), e);
  edges.remove(e);
}

}  // namespace concino::detail
