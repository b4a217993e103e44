// The edges of which those of a clipped volume were made.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/level_sets/detail/clip_verts.hpp>
#include <concino/level_sets/detail/part_lists.hpp>
#include <concino/mesh/correspondence.hpp>
#include <concino/mesh/polyhedralmesh.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace concino::detail {

/// Finds the origins that match_edge finds, mostly without a search: kept edges are in about the same order in both meshes, and the place of a new vert
/// knows its edge.
template<class M>
class clip_edges {
  const M& m_;
  const polyhedralmesh& clipped_;
  const element_origins& of_verts_;
  const clip_verts<M, place_ends>& verts_;
  single_origins found_;
  std::optional<elements_by_index<vert_t<M>>> by_index_;

  bool is_kept(const vert_id& v) const { return v.raw() < verts_.num_kept(); }

 public:
  clip_edges(const M& m, const polyhedralmesh& clipped, const element_origins& of_verts, const clip_verts<M, place_ends>& verts)
      : m_(m), clipped_(clipped), of_verts_(of_verts), verts_(verts), found_(edge_index_bound(clipped)) {}

  /// known: by index of the edge of m, the edge that was made of it, if any; empty if this is to be found.
  element_origins list(const std::vector<std::uint32_t>& known) && {
    if (known.empty()) list_kept();
    for (std::uint32_t e = 0; e < known.size(); ++e)
      if (known[e] != ~0u) found_.set(known[e], e);
    for (const edge_id e : edges(clipped_))
      if (!found_.is_set(e.raw())) list_new(e);
    return std::move(found_).collect();
  }

 private:
  void list_kept() {
    const std::size_t bound = edge_index_bound(clipped_);
    std::size_t next = 0;  // edges of the clipped volume before it are not expected
    for (const edge_t<M> e : edges(m_)) {
      const auto ends = end_verts(m_, e);
      const vert_id a = verts_.of(ends.first), b = verts_.of(ends.second);
      if (a.is_none() || b.is_none()) continue;
      const std::size_t at = edge_between(a, b, next, bound);
      if (at == bound) continue;
      found_.set(at, static_cast<std::uint32_t>(index_of(m_, e)));
      next = at + 1;
    }
  }
  std::size_t edge_between(const vert_id& a, const vert_id& b, std::size_t expected, std::size_t bound) const {
    for (; expected < bound; ++expected) {
      const auto ends = end_verts(clipped_, edge_id{expected});
      if ((ends.first == a && ends.second == b) || (ends.first == b && ends.second == a)) return expected;
      if (is_kept(ends.first) && is_kept(ends.second)) break;
    }
    const auto others = adj_v2v(clipped_, a);  // in the same order as the edges
    const auto at = std::find(others.begin(), others.end(), b);
    return at == others.end() ? bound : adj_v2e(clipped_, a)[static_cast<std::size_t>(at - others.begin())].raw();
  }

  /// Edges between kept verts are new if list_kept() has not found them. An edge from a place on an edge is part of it if it ends at an end of the edge;
  /// between two places, or to the centre of a face, it has no origin. Only a place inside a face may lie on what is an edge elsewhere.
  void list_new(const edge_id& e) {
    const auto ends = end_verts(clipped_, e);
    const bool first_is_kept = is_kept(ends.first), second_is_kept = is_kept(ends.second);
    if (first_is_kept && second_is_kept) return;
    for (const vert_id end : {ends.first, ends.second})
      if (!is_kept(end) && verts_.place_of(end).kind == level_place::inside) {
        if (!by_index_) by_index_.emplace(m_, verts(m_), vert_index_bound(m_));
        found_.set(e.raw(), match_edge(m_, clipped_, of_verts_, *by_index_, e));
        return;
      }
    if (!first_is_kept && !second_is_kept) return;
    const vert_id kept = first_is_kept ? ends.first : ends.second, made = first_is_kept ? ends.second : ends.first;
    const level_place& place = verts_.place_of(made);
    if (place.kind != level_place::edge || place.element >= edge_index_bound(m_)) return;
    const std::uint32_t index = of_verts_.only(kept.raw());
    const auto origins = of_verts_[made.raw()];
    if (origins[0].index == index || origins[1].index == index) found_.set(e.raw(), {place.element, 1 - part_of(origins, index)});
  }
};

}  // namespace concino::detail
