// The adjacent verts, edges and polys of every vert: construction, and updates when the mesh is edited.
#pragma once

#include <concino/mesh/detail/rows/alive_elements.hpp>
#include <concino/mesh/detail/rows/incident_lists.hpp>

namespace concino::detail {

/// The neighbours and edges of every vert from the ends of every edge. degrees[v + 1] is the number of edges at v;
/// `next` is scratch memory with one number per vert.
inline incident_edges make_incident_edges(offsets degrees, const jagged_array<vert_id, 2>& ends,
                                          core::flat_array<std::uint32_t>& next) {
  core::flat_array<vert_id> verts(2 * ends.size());
  core::flat_array<edge_id> edges(2 * ends.size());
  prefix_sum(degrees);
  const auto where = std::make_shared<const offsets>(std::move(degrees));
  std::copy_n(where->begin(), next.size(), next.data());
  for (std::size_t e = 0; e < ends.size(); ++e) {
    const vert_id a = ends.begin(e)[0], b = ends.begin(e)[1];
    const std::uint32_t i = next[a.raw()]++, j = next[b.raw()]++;
    verts[i] = b;
    verts[j] = a;
    edges[i] = edges[j] = edge_id{e};
  }
  return {where, std::move(verts), std::move(edges)};
}

// Of volumes, whose polys are in lists of their own.

/// Makes the lists of verts editable. It comes before the first edit.
inline void make_vertex_incidence_growable(incident_edges& edges_at, jagged_array<poly_id, 0>& v2p) {
  edges_at.make_growable();
  v2p.make_growable();
}

/// After this call n calls of add_lists_of_vert() with that many edges and polys in all cannot fail.
inline void reserve_lists_of_new_verts(incident_edges& edges_at, jagged_array<poly_id, 0>& v2p, std::size_t n,
                                       std::size_t edges, std::size_t polys) {
  make_vertex_incidence_growable(edges_at, v2p);
  edges_at.reserve_verts(n, edges);
  v2p.reserve_rows(n, polys + n * row_places<>::room_unit);
}

/// Adds the empty lists of a new vert, with room for so many edges and polys.
inline void add_lists_of_vert(incident_edges& edges_at, jagged_array<poly_id, 0>& v2p, std::uint32_t edges,
                              std::uint32_t polys) {
  edges_at.add_vert(std::max(edges, 1u));
  v2p.commit_row(0, row_places<>::room_for(std::max(polys, 1u)));
}

// Of surfaces and volumes.

/// After this call, n calls of add_edge() cannot fail because of the rows of this end v.
inline void reserve_edges_at(incident_edges& edges_at, vert_id v, std::uint32_t n) {
  if (n > 0) edges_at.reserve_at(v, n);
}

template<bool WithPolys>
edge_id add_edge(alive_elements<edge_id>& edges, jagged_array<vert_id, 2>& ends, incident_lists<WithPolys>& edges_at,
                 vert_id a, vert_id b) {
  const edge_id e = edges.add();
  const vert_id two[] = {std::min(a, b), std::max(a, b)};
  ends.add_row(two, two + 2);
  edges_at.push(a, b, e);
  edges_at.push(b, a, e);
  return e;
}

/// Both rows of a vert keep their order.
template<bool WithPolys>
void remove_edge(alive_elements<edge_id>& edges, const jagged_array<vert_id, 2>& ends,
                 incident_lists<WithPolys>& edges_at, edge_id e) {
  for (const vert_id v : ends[e.raw()]) edges_at.remove(v, e);
  edges.remove(e);
}

}  // namespace concino::detail
