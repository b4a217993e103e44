// Cells that a level set cuts in two parts; see simple_cells.hpp.
#pragma once

#include <concino/core/large_pages.hpp>
#include <concino/core/sort_numbers.hpp>
#include <concino/level_sets/detail/convex_cells.hpp>
#include <concino/level_sets/detail/polygon_crossings.hpp>
#include <concino/level_sets/detail/simple_cells.hpp>

#include <algorithm>

namespace concino::detail {

CONCINO_INLINE void simple_cells::reserve(std::size_t n) {
  core::reserve_pages(cells_, n), core::reserve_pages(caps_, 6 * n), core::reserve_pages(entries_, 6 * n);
  core::reserve_pages(faces_, 4 * n), core::reserve_pages(corners_, 16 * n);
  core::reserve_pages(keys_, 4 * n);
}

CONCINO_INLINE void simple_cells::start_cell(bool is_difficult) {
  const auto first_entry = static_cast<std::uint32_t>(entries_.size()), first_cap = static_cast<std::uint32_t>(caps_.size());
  cells_.push_back({first_entry, first_entry, first_cap, first_cap, false, true, is_difficult});
  chords_.clear();
  surface_.clear();
}

CONCINO_INLINE void simple_cells::start_face(std::uint32_t index) {
  const auto first = static_cast<std::uint32_t>(corners_.size());
  faces_.push_back({index, first, first, {none, none}, {none, none}, {none, none}, 0, false, true, false});
}

CONCINO_INLINE bool simple_cells::read_corners(std::uint32_t number, bool is_new, const cell_verts& verts) {
  face& f = faces_[number];
  if (is_new) f.last_corner = static_cast<std::uint32_t>(corners_.size());
  local_.clear();
  const std::uint32_t *const all = verts.indices.data(), n = static_cast<std::uint32_t>(verts.indices.size());
  for (std::uint32_t k = f.first_corner; k < f.last_corner; ++k) {
    std::uint32_t i = 0;
    while (i < n && all[i] != corners_[k]) ++i;
    if (i == n) return false;
    local_.push_back(i);
    surface_.add_corner(corners_[k]);
  }
  if (is_new) find_chord(f, verts);
  return true;
}

/// Of a face that is not crossed, the same for the same verts in any order; else of its chord.
CONCINO_INLINE std::uint64_t simple_cells::key_of(const face& f) const {
  if (f.is_crossed) return std::uint64_t{std::min(f.places[0], f.places[1])} << 32 | std::max(f.places[0], f.places[1]);
  std::uint64_t key = 0;
  for (std::uint32_t k = f.first_corner; k < f.last_corner; ++k) {
    const std::uint64_t x = (corners_[k] + std::uint64_t{1}) * 0x9e3779b97f4a7c15u;
    key += x ^ x >> 29;
  }
  return key;
}

CONCINO_INLINE void simple_cells::find_chord(face& f, const cell_verts& verts) {
  const auto n = static_cast<std::uint32_t>(local_.size());
  unsigned num_ends = 0;
  f.starts_above = verts.above[local_[0]] != 0;
  for (std::uint32_t k = 0; k < n; ++k) {
    if (verts.above[local_[k]] == verts.above[local_[k + 1 < n ? k + 1 : 0]]) continue;
    if (num_ends < 2) f.ends[num_ends] = k;
    ++num_ends;
  }
  f.is_crossed = num_ends > 0;
  f.is_simple = num_ends <= 2;
  if (!f.is_crossed) {
    keys_.push_back(key_of(f));
    return;
  }
  ++num_crossed_, num_crossed_corners_ += n;
  if (n == 3 || !f.is_simple) return;
  points_.clear();
  for (const std::uint32_t i : local_) points_.push_back(verts.points[i]);
  f.is_simple = is_convex_polygon(points_);
}

CONCINO_INLINE bool simple_cells::is_planar(const cell_verts& verts) {
  points_.clear();
  for (const std::uint32_t i : local_) points_.push_back(verts.points[i]);
  return points_.size() == 3 || is_planar_polygon(points_);
}

CONCINO_INLINE void simple_cells::set_chord(std::uint32_t first_place, std::uint32_t second_place, std::uint32_t poly, std::uint32_t other_poly) {
  face& f = faces_.back();
  f.places[0] = first_place, f.places[1] = second_place;
  f.polys[0] = poly, f.polys[1] = other_poly;
  keys_.push_back(key_of(f));
}

/// Equal keys of different faces or chords are as good as impossible, and only cost time.
CONCINO_INLINE bool simple_cells::has_equal_faces() {
  core::sort_numbers(keys_.data(), keys_.data() + keys_.size());
  return std::adjacent_find(keys_.begin(), keys_.end()) != keys_.end();
}

CONCINO_INLINE void simple_cells::add_face(std::uint32_t number, bool outward, std::uint32_t poly, const cell_verts& verts) {
  const face& f = faces_[number];
  cell& c = cells_.back();
  if (entries_.size() == c.first_entry) c.starts_above = f.starts_above;
  entries_.push_back({number, outward});
  surface_.end_facet(outward);
  c.is_difficult = c.is_difficult || !f.is_simple;
  if (c.is_difficult) return;
  c.is_convex = c.is_convex && !is_vert_outside(verts.points, local_, outward);
  if (!f.is_crossed) return;
  const unsigned start = f.starts_above == outward ? 0 : 1;
  chords_.push_back({f.places[start], f.places[1 - start], f.polys[0] == poly ? f.polys[1] : f.polys[0]});
}

/// Lists the loop from the first chord on. Returns false if there is another one.
CONCINO_INLINE bool simple_cells::chain_chords() {
  std::size_t left = chords_.size();
  if (left < 3) return false;
  std::uint32_t at = chords_[0].end;
  caps_.push_back(chords_[0].start);
  const std::uint32_t start = chords_[0].start, other = chords_[0].other;
  bool between_two_cells = other != none;
  chords_[0] = chords_[--left];
  while (left > 0) {
    std::size_t k = 0;
    while (k < left && chords_[k].start != at) ++k;
    if (k == left || at == start) return false;
    caps_.push_back(at);
    at = chords_[k].end;
    between_two_cells = between_two_cells && chords_[k].other == other;
    chords_[k] = chords_[--left];
  }
  return at == start && !between_two_cells;
}

CONCINO_INLINE void simple_cells::end_cell(bool is_known_sphere, std::size_t num_verts, std::size_t num_edges) {
  cell& c = cells_.back();
  c.last_entry = static_cast<std::uint32_t>(entries_.size());
  c.is_difficult = c.is_difficult || !chain_chords() || !(is_known_sphere || surface_.is_sphere(num_verts, num_edges));
  if (c.is_difficult) {
    for (std::uint32_t i = c.first_entry; i < c.last_entry; ++i) ++faces_[entries_[i].face].num_difficult;
    caps_.resize(c.first_cap);
  }
  c.last_cap = static_cast<std::uint32_t>(caps_.size());
  sort_entries(c);
}

CONCINO_INLINE void simple_cells::sort_entries(const cell& c) {
  for (std::uint32_t i = c.first_entry + 1; i < c.last_entry; ++i) {  // few, and nearly sorted
    const entry x = entries_[i];
    std::uint32_t k = i;
    for (; k > c.first_entry && entries_[k - 1].face > x.face; --k) entries_[k] = entries_[k - 1];
    entries_[k] = x;
  }
}

CONCINO_INLINE std::vector<std::uint32_t> simple_cells::cells_to_cut() const {
  std::vector<std::uint32_t> cells;
  for (std::uint32_t c = 0; c < cells_.size(); ++c) {
    bool cut = cells_[c].is_difficult;
    for (std::uint32_t i = cells_[c].first_entry; !cut && i < cells_[c].last_entry; ++i) cut = faces_[entries_[i].face].num_difficult > 0;
    if (cut) cells.push_back(c);
  }
  return cells;
}

}  // namespace concino::detail
