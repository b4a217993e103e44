// The surface of a cell; see cell_surface.hpp.
#pragma once

#include <concino/level_sets/detail/cell_surface.hpp>

#include <algorithm>

namespace concino::detail {

CONCINO_INLINE void cell_surface::list_edges() {
  edges_.clear(), sides_.clear();
  std::uint32_t first = 0;
  for (std::uint32_t side = 0; side < ends_.size(); first = ends_[side++])
    for (std::uint32_t k = first; k < ends_[side]; ++k) {
      const std::uint32_t a = verts_[k], b = verts_[k + 1 < ends_[side] ? k + 1 : first];
      edges_.push_back(a < b ? std::uint64_t{a} << 32 | b : std::uint64_t{b} << 32 | a);
      sides_.push_back(side);
    }
}

CONCINO_INLINE void cell_surface::clear_slots() {
  std::size_t size = 64;
  while (size < 2 * verts_.size()) size *= 2;
  slots_.assign(size, none);
}

/// Where a hash table has the first corner with the same key as this one.
template<class Key>
std::uint32_t& cell_surface::slot_of(const std::vector<Key>& keys, std::uint32_t corner) {
  const std::uint32_t mask = static_cast<std::uint32_t>(slots_.size() - 1);
  const Key key = keys[corner];
  std::uint32_t i = static_cast<std::uint32_t>(key * 0x9e3779b97f4a7c15u >> 32) & mask;
  while (slots_[i] != none && keys[slots_[i]] != key) i = (i + 1) & mask;
  return slots_[i];
}

CONCINO_INLINE bool cell_surface::find_mates() {
  const auto n = static_cast<std::uint32_t>(verts_.size());
  list_edges();
  mates_.assign(n, none);
  clear_slots();
  for (std::uint32_t k = 0; k < n; ++k) {
    std::uint32_t& slot = slot_of(edges_, k);
    if (slot == none) {
      slot = k;
      continue;
    }
    const bool same_way = verts_[slot] == verts_[k];
    if (mates_[slot] != none || same_way == (outward_[sides_[slot]] == outward_[sides_[k]])) return false;
    mates_[slot] = k, mates_[k] = slot;
  }
  return std::find(mates_.begin(), mates_.end(), none) == mates_.end();
}

/// Sums a hash of each edge, with the sign of its direction. If the sum is 0 and there are twice as many corners as edges, each edge is used once in each
/// direction. Then see is_sphere(): a second surface takes at least 4 sides, and one more to be a sphere, or a torus, which has at least 7.
CONCINO_INLINE bool cell_surface::is_sphere(std::size_t num_verts, std::size_t num_edges) {
  if (verts_.size() != 2 * num_edges || num_verts + ends_.size() != num_edges + 2) return false;
  std::uint64_t sum = 0;
  std::uint32_t first = 0;
  for (std::uint32_t side = 0; side < ends_.size(); first = ends_[side++]) {
    std::uint64_t of_side = 0, a = verts_[ends_[side] - 1];
    for (std::uint32_t k = first; k < ends_[side]; ++k) {
      const std::uint64_t b = verts_[k], hash = ((a < b ? a << 32 | b : b << 32 | a) + 1) * 0x9e3779b97f4a7c15u, mixed = (hash ^ hash >> 31) * 0xbf58476d1ce4e5b9u;
      of_side += a < b ? mixed : std::uint64_t{0} - mixed;
      a = b;
    }
    sum += outward_[side] ? of_side : std::uint64_t{0} - of_side;
  }
  return sum == 0 && (ends_.size() < 8 || is_sphere());
}

/// The same as is_sphere() for cells with few verts and sides, which sets is_small. The table has the side of each pair of verts, by their order in it.
CONCINO_INLINE bool cell_surface::is_small_sphere(bool& is_small) const {
  const auto n = static_cast<std::uint32_t>(verts_.size()), num_sides = static_cast<std::uint32_t>(outward_.size());
  if (num_sides > few || num_sides == 0) return false;
  constexpr std::uint32_t num_slots = 4 * few;
  unsigned char slots[num_slots] = {}, side_of[few * few] = {}, local[16 * few];
  std::uint32_t known[few], num_verts = 0;
  if (n > sizeof local) return false;
  for (std::uint32_t k = 0; k < n; ++k) {
    std::uint32_t i = verts_[k] * 0x9e3779b1u >> 25 & (num_slots - 1);
    while (slots[i] != 0 && known[slots[i] - 1] != verts_[k]) i = (i + 1) & (num_slots - 1);
    if (slots[i] == 0) {
      if (num_verts == few) return false;
      known[num_verts++] = verts_[k];
      slots[i] = static_cast<unsigned char>(num_verts);
    }
    local[k] = static_cast<unsigned char>(slots[i] - 1);
  }
  is_small = true;
  if (num_verts + num_sides != n / 2 + 2 || n % 2 != 0) return false;
  for (std::uint32_t first = 0, side = 0; side < num_sides; first = ends_[side++]) {
    std::uint32_t a = local[ends_[side] - 1];
    for (std::uint32_t k = first; k < ends_[side]; ++k) {
      const std::uint32_t b = local[k];
      unsigned char& use = side_of[outward_[side] ? few * a + b : few * b + a];
      if (use != 0) return false;
      use = static_cast<unsigned char>(side + 1);
      a = b;
    }
  }
  std::uint32_t across[few] = {};  // by side: the sides across its edges, as bits
  for (std::uint32_t a = 0; a < num_verts; ++a)
    for (std::uint32_t b = a + 1; b < num_verts; ++b) {
      const std::uint32_t x = side_of[few * a + b], y = side_of[few * b + a];
      if ((x == 0) != (y == 0)) return false;
      if (x != 0) across[x - 1] |= 1u << (y - 1), across[y - 1] |= 1u << (x - 1);
    }
  std::uint32_t reached = 1, before = 0;
  while (reached != before) {
    before = reached;
    for (std::uint32_t side = 0; side < num_sides; ++side)
      if (reached >> side & 1u) reached |= across[side];
  }
  return reached == (num_sides == few ? ~0u : (1u << num_sides) - 1u);
}

/// Edges have two sides each. So the sides form closed surfaces, whose Euler characteristics sum to V - E + F plus one for each additional fan of sides at a
/// vert. If they are one surface, this is at most 2, and 2 is left only to a sphere that does not touch itself.
CONCINO_INLINE bool cell_surface::is_sphere() {
  bool is_small = false;
  const bool is_sphere = is_small_sphere(is_small);
  if (is_small) return is_sphere;
  if (!find_mates()) return false;
  const std::size_t num_sides = outward_.size();
  pieces_ = disjoint_sets(num_sides);
  std::size_t num_pieces = num_sides, num_verts = 0;
  clear_slots();
  for (std::uint32_t k = 0; k < verts_.size(); ++k) {
    if (mates_[k] > k) num_pieces -= pieces_.unite(sides_[k], sides_[mates_[k]]);
    std::uint32_t& slot = slot_of(verts_, k);
    if (slot != none) continue;
    slot = k;
    ++num_verts;
  }
  return num_pieces == 1 && num_verts + num_sides == verts_.size() / 2 + 2;
}

}  // namespace concino::detail
