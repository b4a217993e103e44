// Compaction of tables of surfaces; see surface_tables.hpp.
#pragma once

#include <concino/mesh/detail/tables/compaction.hpp>
#include <concino/mesh/surface_tables.hpp>

namespace concino {

template<unsigned Arity, class Lists>
surface_tables<Arity, Lists> surface_tables<Arity, Lists>::compacted(const detail::compaction& kept) const {
  surface_tables t;
  t.p2v_ = detail::packed_rows(p2v_, kept.polys, kept.verts);
  t.facet_adjacency_ = facet_adjacency_.compacted(kept.edges, kept.polys);
  if constexpr (Arity == 0) t.p2v_.share_offsets(t.facet_adjacency_.facet_rows());
  t.e2v_ = detail::packed_rows(e2v_, kept.edges, kept.verts);
  t.incident_ = {detail::packed_edges(incident_, kept.verts, kept.edges),
                 detail::pack_rows<poly_id>(
                     kept.verts, [this](std::size_t v) { return adj_v2p(vert_id{v}); }, kept.polys)};
  t.verts_ = detail::alive_elements<vert_id>(kept.verts.size());
  t.edges_ = detail::alive_elements<edge_id>(kept.edges.size());
  t.polys_ = detail::alive_elements<poly_id>(kept.polys.size());
  return t;
}

}  // namespace concino
