// Compaction of tables of polyhedra; see polyhedra_tables.hpp.
#pragma once

#include <concino/mesh/detail/tables/compaction.hpp>
#include <concino/mesh/polyhedra_tables.hpp>

#include <algorithm>

namespace concino {

template<class Lists>
basic_polyhedra_tables<Lists> basic_polyhedra_tables<Lists>::compacted(const detail::compaction& kept) const {
  basic_polyhedra_tables t;
  t.f2v_ = detail::packed_rows(f2v_, kept.faces, kept.verts);
  t.p2v_ = detail::packed_rows(p2v_, kept.polys, kept.verts);
  t.p2e_ = detail::packed_rows(p2e_, kept.polys, kept.edges);
  t.e2f_ = detail::packed_rows(e2f_, kept.edges, kept.faces);
  t.e2v_ = detail::packed_rows(e2v_, kept.edges, kept.verts);
  t.incident_edges_ = detail::packed_edges(incident_edges_, kept.verts, kept.edges);
  t.sort_smaller_neighbours();
  t.v2p_ = detail::packed_rows(v2p_, kept.verts, kept.polys);
  if (*t.v2p_.shared_offsets() == *t.incident_edges_.shared_offsets()) t.v2p_.share_offsets(t.incident_edges_);
  t.facet_adjacency_ = facet_adjacency_.compacted(kept.faces, kept.polys);
  t.outward_ = detail::packed_rows(outward_, kept.polys, [](std::uint8_t x) { return x; });
  t.outward_.share_offsets(t.facet_adjacency_.facet_rows());
  t.face_vert_lookup_ = detail::row_lookup(t.f2v_);
  t.verts_ = detail::alive_elements<vert_id>(kept.verts.size());
  t.edges_ = detail::alive_elements<edge_id>(kept.edges.size());
  t.faces_ = detail::alive_elements<face_id>(kept.faces.size());
  t.polys_ = detail::alive_elements<poly_id>(kept.polys.size());
  return t;
}

/// Sorts long lists of neighbours as edge_to_smaller() needs them: those smaller than the vert come first, in ascending
/// order.
template<class Lists>
void basic_polyhedra_tables<Lists>::sort_smaller_neighbours() {
  struct neighbour {
    vert_id vert;
    edge_id edge;
  };
  std::vector<neighbour> row;
  for (std::size_t i = 0; i < incident_edges_.size(); ++i) {
    const std::uint32_t n = incident_edges_.num_edges(vert_id{i});
    if (n <= detail::row_lookup::longest_scan) continue;
    row.clear();
    vert_id* const verts = incident_edges_.verts_begin(vert_id{i});
    edge_id* const edges = incident_edges_.edges_begin(vert_id{i});
    for (std::uint32_t k = 0; k < n; ++k) row.push_back({verts[k], edges[k]});
    const auto rank = [i](const neighbour& x) {
      return x.vert.raw() < i ? x.vert.raw() : static_cast<std::uint32_t>(i);
    };
    std::stable_sort(row.begin(), row.end(), [&](const neighbour& a, const neighbour& b) { return rank(a) < rank(b); });
    for (std::uint32_t k = 0; k < n; ++k) verts[k] = row[k].vert, edges[k] = row[k].edge;
  }
}

}  // namespace concino
