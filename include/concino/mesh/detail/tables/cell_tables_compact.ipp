// Compaction of tables of tets and hexes; see cell_tables.hpp.
#pragma once

#include <concino/mesh/cell_tables.hpp>
#include <concino/mesh/detail/tables/compaction.hpp>

namespace concino {

template<class Shape, class Lists>
cell_tables<Shape, Lists> cell_tables<Shape, Lists>::compacted(const detail::compaction& kept) const {
  cell_tables t;
  t.p2v_ = detail::packed_rows(p2v_, kept.polys, kept.verts);
  t.p2e_ = detail::packed_rows(p2e_, kept.polys, kept.edges);
  t.facet_adjacency_ = facet_adjacency_.compacted(kept.faces, kept.polys);
  t.e2v_ = detail::packed_rows(e2v_, kept.edges, kept.verts);
  t.incident_edges_ = detail::packed_edges(incident_edges_, kept.verts, kept.edges);
  t.v2p_ = detail::packed_rows(v2p_, kept.verts, kept.polys);
  t.verts_ = detail::alive_elements<vert_id>(kept.verts.size());
  t.edges_ = detail::alive_elements<edge_id>(kept.edges.size());
  t.faces_ = detail::alive_elements<face_id>(kept.faces.size());
  t.polys_ = detail::alive_elements<poly_id>(kept.polys.size());

  t.e2p_.resize(kept.edges.size());
  detail::offsets lengths{0};  // of the lists of polys at edges around which a walk does not meet all polys
  for (std::size_t e = 0; e < kept.edges.size(); ++e) {
    const edge_id before{kept.edges.before(e)};
    if (!is_non_manifold(before)) {
      t.e2p_[e] = kept.polys.after(e2p_[before.raw()]);
      continue;
    }
    t.e2p_[e] = detail::encoded_neighbour::special | static_cast<std::uint32_t>(lengths.size() - 1);
    lengths.push_back(poly_lists_.length(poly_list_number(before)));
  }
  if (lengths.size() == 1) return t;
  t.poly_lists_ = detail::make_jagged_array<poly_id>(std::move(lengths));
  for (std::size_t e = 0; e < kept.edges.size(); ++e) {
    if (!t.is_non_manifold(edge_id{e})) continue;
    poly_id* to = t.poly_lists_.begin(t.poly_list_number(edge_id{e}));
    for (const poly_id p : poly_list(edge_id{kept.edges.before(e)})) *to++ = kept.polys(p);
  }
  return t;
}

}  // namespace concino
