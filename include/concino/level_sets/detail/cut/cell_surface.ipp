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

CONCINO_INLINE void cell_surface::clear_slots() {
  std::size_t size = 64;
  while (size < 2 * verts_.size()) size *= 2;
  slots_.assign(size, none);
}

/// Where a hash table has the first corner with the same edge as this one.
CONCINO_INLINE std::uint32_t& cell_surface::slot_of(std::uint32_t corner) {
  const auto mask = static_cast<std::uint32_t>(slots_.size() - 1);
  const std::uint64_t key = edges_[corner];
  std::uint32_t i = static_cast<std::uint32_t>(key * 0x9e3779b97f4a7c15u >> 32) & mask;
  while (slots_[i] != none && edges_[slots_[i]] != key) i = (i + 1) & mask;
  return slots_[i];
}

CONCINO_INLINE bool cell_surface::find_mates() {
  const auto n = static_cast<std::uint32_t>(verts_.size());
  list_edges();
  mates_.assign(n, none);
  clear_slots();
  for (std::uint32_t k = 0; k < n; ++k) {
    std::uint32_t& slot = slot_of(k);
    if (slot == none) {
      slot = k;
      continue;
    }
    const bool same_way = verts_[slot] == verts_[k];
    if (mates_[slot] != none || same_way == (outward_[facets_[slot]] == outward_[facets_[k]])) return false;
    mates_[slot] = k, mates_[k] = slot;
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

/// Edges have two facets each. So the facets form closed surfaces, whose Euler characteristics sum to V - E + F plus one for each additional fan of facets at a
/// vert. One surface has at most 2, and 2 only if it is a sphere that does not touch itself. Two surfaces have at least 8 facets: a tetrahedron has 4, and a torus 7.
CONCINO_INLINE bool cell_surface::is_sphere(std::size_t num_verts) {
  return num_verts + ends_.size() == verts_.size() / 2 + 2 && (ends_.size() <= few || are_connected());
}

}  // namespace concino::detail
