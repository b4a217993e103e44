// The surface of a cell; see cell_surface.hpp.
#pragma once

#include <concino/level_sets/detail/cut/cell_surface.hpp>

#include <algorithm>

namespace concino::detail {

CONCINO_INLINE void cell_surface::list_edges() {
  edges_.clear(), facets_.clear();
  std::uint32_t first = 0;
  for (std::uint32_t facet = 0; facet < ends_.size(); first = ends_[facet++])
    for (std::uint32_t k = first; k < ends_[facet]; ++k) {
      const std::uint32_t a = verts_[k], b = verts_[k + 1 < ends_[facet] ? k + 1 : first];
      edges_.push_back(a < b ? std::uint64_t{a} << 32 | b : std::uint64_t{b} << 32 | a);
      facets_.push_back(facet);
    }
}

CONCINO_INLINE bool cell_surface::find_mates() {
  const auto n = static_cast<std::uint32_t>(verts_.size());
  list_edges();
  mates_.assign(n, none);
  first_at_.clear();
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t hash = core::index_table::hash(edges_[k]),
                        first = first_at_.find(hash, [&](std::uint32_t i) { return edges_[i] == edges_[k]; });
    if (first == none) {
      first_at_.add(hash, k);
      continue;
    }
    const bool same_way = verts_[first] == verts_[k];
    if (mates_[first] != none || same_way == (outward_[facets_[first]] == outward_[facets_[k]])) return false;
    mates_[first] = k, mates_[k] = first;
  }
  return std::find(mates_.begin(), mates_.end(), none) == mates_.end();
}

/// Whether all facets are connected across edges, after find_mates().
CONCINO_INLINE bool cell_surface::are_connected() {
  pieces_ = disjoint_sets(ends_.size());
  std::size_t num_pieces = ends_.size();
  for (std::uint32_t k = 0; k < verts_.size(); ++k)
    if (mates_[k] > k) num_pieces -= pieces_.unite(facets_[k], facets_[mates_[k]]);
  return num_pieces == 1;
}

/// Edges have two facets each. So the facets form closed surfaces, whose Euler characteristics sum to V - E + F plus
/// one for each additional fan of facets at a vert. One surface has at most 2, and 2 only if it is a sphere that does
/// not touch itself. Two surfaces have at least 8 facets: a tetrahedron has 4, and a torus 7.
CONCINO_INLINE bool cell_surface::is_sphere(std::size_t num_verts) {
  return num_verts + ends_.size() == verts_.size() / 2 + 2 && (ends_.size() <= few || are_connected());
}

}  // namespace concino::detail
