// Collects the sectors of all polys around the verts of a surface or the edges of a volume.
#pragma once

#include <concino/concepts/oriented_edges.hpp>
#include <concino/core/error.hpp>
#include <concino/generate/detail/dual/oriented_edge_table.hpp>
#include <concino/generate/detail/dual/sector_fans.hpp>

namespace concino::detail {

template<class... Pieces>
[[noreturn]] void throw_no_dual(const Pieces&... pieces) {
  core::throw_joined<invalid_mesh>({"dual_mesh: ", pieces..., "; validate() lists what is wrong with the mesh"});
}

/// Collects the sectors around the verts of a surface. Polys are identified by number_of(p), facets and centres by
/// index.
template<SurfaceMesh M, class NumberOf>
void read_sectors(const M& m, const NumberOf& number_of, sector_fans& fans) {
  for (const poly_t<M> p : polys(m))
    for (const vert_t<M> v : adj_p2v(m, p)) fans.count(index_of(m, v));
  fans.end_counting();
  for (const poly_t<M> p : polys(m)) {
    std::uint32_t before = sector::none;
    sector* first = nullptr;
    for (const auto& edge : oriented_edges(m, p)) {
      sector& w = fans.at(index_of(m, edge.from), number_of(p));
      if (first == nullptr) first = &w;
      w.out = before;
      before = w.in = static_cast<std::uint32_t>(index_of(m, edge.edge));
    }
    if (first != nullptr) first->out = before;
  }
}

/// Collects the sectors around the edges of a volume. Errors: invalid_mesh that names a poly whose surface is not
/// closed.
template<VolumeMesh M, class NumberOf>
void read_sectors(const M& m, const NumberOf& number_of, sector_fans& fans, const oriented_edge_table<M>& oriented) {
  for (const poly_t<M> p : polys(m))
    for (const edge_t<M> e : adj_p2e(m, p)) fans.count(index_of(m, e));
  fans.end_counting();
  for (const poly_t<M> p : polys(m)) {
    const std::uint32_t n = number_of(p);
    for (const face_t<M> f : adj_p2f(m, p)) {
      const auto facet = static_cast<std::uint32_t>(index_of(m, f));
      const bool outward = face_is_outward(m, p, f);
      for (const indexed_oriented_edge& s : oriented.of(facet)) {
        sector& w = fans.at(s.edge, n);
        // the face whose outward orientation follows the edge is `out`
        std::uint32_t& slot = (s.forward != 0) == outward ? w.out : w.in;
        if (slot != sector::none)
          throw_no_dual("poly ", index_of(m, p), " has more than two faces at edge ", std::size_t{s.edge});
        slot = facet;
      }
    }
    for (const edge_t<M> e : adj_p2e(m, p))
      if (const sector& w = fans.at(index_of(m, e), n); w.in == sector::none || w.out == sector::none)
        throw_no_dual("poly ", index_of(m, p), " is not closed at edge ", index_of(m, e));
  }
}

}  // namespace concino::detail
