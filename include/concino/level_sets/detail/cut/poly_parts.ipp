// The parts into which a level set cuts polygons; see poly_parts.hpp.
#pragma once

#include <concino/level_sets/detail/cut/level_states.hpp>
#include <concino/level_sets/detail/cut/poly_parts.hpp>

#include <algorithm>

namespace concino::detail {

CONCINO_INLINE poly_parts::poly_parts(poly_cuts& cuts) : cuts_(cuts), s_(cuts.surface()) {
  is_moved_.assign(cuts_.num_corners(), not_moved);
  remove_flat_chords();
  find_added_edges();
  part_at_.assign(cuts_.num_corners(), none);
  for (std::uint32_t c = 0; c < cuts_.num_corners(); ++c)
    if (part_at_[c] == none) add_part(c);
  find_cut_edges();
  places = std::move(numbers_.places);
}

/// The corners of the part on one side of a chord.
CONCINO_INLINE std::vector<std::uint32_t> poly_parts::corners_of_part(const poly_cuts::chord& c, bool above) const {
  std::vector<std::uint32_t> corners;
  const std::uint32_t start = above ? cuts_.next(c.to) : cuts_.next(c.from);
  for (std::uint32_t k = start; corners.empty() || k != start;) {
    corners.push_back(k);
    const std::uint32_t chord = cuts_.chord_at(k);
    if (chord == none) k = cuts_.next(k);
    else k = cuts_.next(cuts_.chords()[chord].from == k ? cuts_.chords()[chord].to : cuts_.chords()[chord].from);
  }
  return corners;
}

/// Whether the parts on one side of two chords have the same verts and no other chords. If so, the chords no longer
/// cut.
CONCINO_INLINE bool poly_parts::change(poly_cuts::chord& a, poly_cuts::chord& b, bool above) {
  const std::vector<std::uint32_t> at_a = corners_of_part(a, above), at_b = corners_of_part(b, above);
  const auto chords = [&](const std::vector<std::uint32_t>& corners) {
    return std::count_if(corners.begin(), corners.end(), [&](std::uint32_t k) { return cuts_.chord_at(k) != none; });
  };
  const auto verts = [&](const std::vector<std::uint32_t>& corners) {
    std::vector<std::uint32_t> all;
    for (const std::uint32_t k : corners) all.push_back(s_.verts[k]);
    std::sort(all.begin(), all.end());
    return all;
  };
  if (chords(at_a) != 1 || chords(at_b) != 1 || verts(at_a) != verts(at_b)) return false;
  a.cuts = b.cuts = false;
  for (const auto* const corners : {&at_a, &at_b})
    for (const std::uint32_t k : *corners) is_moved_[k] = above ? moved_below : moved_above;
  for (const std::uint32_t k : at_a) moved_verts.push_back(s_.verts[k]);
  return true;
}

/// Whether all places of a chord are one of its ends.
CONCINO_INLINE bool poly_parts::is_segment(const poly_cuts::chord& c) const {
  const chord_places x(cuts_, c);
  for (std::uint32_t k = 1; k + 1 < x.size(); ++k)
    if (x[k] != x[0] && x[k] != x[x.size() - 1]) return false;
  return true;
}

/// Where two chords have the same ends in opposite order, and a part at both of them has the same verts, there is
/// nothing between the chords but edges that two polys share. These chords no longer cut: the part counts as what is
/// around it.
CONCINO_INLINE void poly_parts::remove_flat_chords() {
  struct ends {
    std::uint32_t low, high, chord;
    bool turned;
  };
  std::vector<ends> all;
  for (std::uint32_t i = 0; i < cuts_.chords().size(); ++i) {
    const poly_cuts::chord& c = cuts_.chords()[i];
    if (!c.cuts || !is_segment(c)) continue;
    const std::uint32_t a = numbers_.add(cuts_.crossing(c.from)), b = numbers_.add(cuts_.crossing(c.to));
    all.push_back({std::min(a, b), std::max(a, b), i, b < a});
  }
  std::sort(all.begin(), all.end(), [](const ends& a, const ends& b) {
    return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.chord < b.chord;
  });
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size() && all[j].low == all[i].low && all[j].high == all[i].high; ++j) {
      poly_cuts::chord &a = cuts_.chords()[all[i].chord], &b = cuts_.chords()[all[j].chord];
      if (!a.cuts || !b.cuts || all[i].turned == all[j].turned || a.poly == b.poly) continue;
      if (!change(a, b, true)) change(a, b, false);
    }
  std::sort(moved_verts.begin(), moved_verts.end());
  moved_verts.erase(std::unique(moved_verts.begin(), moved_verts.end()), moved_verts.end());
}

CONCINO_INLINE void poly_parts::find_added_edges() {
  for (const poly_cuts::chord& c : cuts_.chords()) {
    if (!c.cuts) continue;
    added_edges_.add(s_.edges[c.from]);
    added_edges_.add(s_.edges[c.to]);
  }
}

/// Adds the part at a corner: it is bounded by edges of the poly and by chords that cut.
CONCINO_INLINE void poly_parts::add_part(std::uint32_t corner) {
  const auto number = static_cast<std::uint32_t>(part_above_.size());
  bool is_above = false, is_whole = true;
  polygon_.clear();
  for (std::uint32_t k = corner; part_at_[k] == none;) {
    part_at_[k] = number;
    is_above = is_above || is_moved_[k] == moved_above ||
               (cuts_.state(k) == poly_cuts::is_above && is_moved_[k] != moved_below);
    const std::uint32_t v = s_.verts[k], chord = cuts_.chord_at(k);
    add_place({level_place::vert, v, v, v});
    if (chord == none || !cuts_.chords()[chord].cuts) {
      if (chord != none && added_edges_.find(s_.edges[k]) != core::local_numbers::none) {
        const level_place x = cuts_.crossing(k);
        if (x.kind != level_place::vert) {
          is_whole = false;
          add_place(x);
        }
      }
      k = cuts_.next(k);
      continue;
    }
    is_whole = false;
    const poly_cuts::chord& c = cuts_.chords()[chord];
    const bool forward = c.from == k;
    const std::uint32_t n = c.inner_end - c.inner_begin;
    add_place(cuts_.crossing(forward ? c.from : c.to));
    for (std::uint32_t i = 0; i < n; ++i)
      add_place(cuts_.crossing(c, forward ? c.inner_begin + i : c.inner_end - 1 - i));
    add_place(cuts_.crossing(forward ? c.to : c.from));
    k = cuts_.next(forward ? c.to : c.from);
  }
  part_above_.push_back(is_above);
  add_polygons(cuts_.poly_of(corner), is_above, is_whole);
}

/// Adds the current polygon: equal places that follow each other are joined, and a polygon that comes to one place
/// twice is cut there.
CONCINO_INLINE void poly_parts::add_polygons(std::uint32_t poly, bool is_above, bool is_whole) {
  const auto add = [&](std::size_t first) {
    if (open_.size() - first > 2) {
      const auto start = static_cast<std::uint32_t>(part_places.size());
      part_places.insert(part_places.end(), open_.begin() + static_cast<std::ptrdiff_t>(first), open_.end());
      parts.push_back({poly, start, static_cast<std::uint32_t>(part_places.size()), is_above, is_whole});
    }
    for (std::size_t k = first; k < open_.size(); ++k) position_[open_[k]] = none;
    open_.resize(first);
  };
  open_.clear();
  if (position_.size() < numbers_.places.size()) position_.resize(numbers_.places.size() + polygon_.size(), none);
  for (std::size_t k = 0; k < polygon_.size(); ++k) {
    const std::uint32_t x = polygon_[k];
    if (x == polygon_[k + 1 < polygon_.size() ? k + 1 : 0]) continue;
    if (const std::uint32_t start = position_[x]; start != none) add(start);
    position_[x] = static_cast<std::uint32_t>(open_.size());
    open_.push_back(x);
  }
  add(0);
}

/// The chords that cut, and edges on the level set between a part below and a part above. Where two of these coincide,
/// there is nothing between them, and what is on both sides is of one kind.
CONCINO_INLINE void poly_parts::find_cut_edges() {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> all;
  const auto add = [&](const level_place& a, const level_place& b) {
    const std::uint32_t x = numbers_.add(a), y = numbers_.add(b);
    if (x != y) all.push_back({x, y});
  };
  for (const poly_cuts::chord& c : cuts_.chords()) {
    if (!c.cuts) continue;
    const chord_places x(cuts_, c);
    for (std::uint32_t k = 0; k + 1 < x.size(); ++k) add(x[k], x[k + 1]);
  }
  for (std::uint32_t k = 0; k < cuts_.num_corners(); ++k) {
    if (cuts_.chord_at(k) != none || part_above_[part_at_[k]] || s_.num_polys[s_.edges[k]] != 2) continue;
    const std::uint32_t other = cuts_.other_use(k), a = s_.verts[k], b = s_.verts[cuts_.next(k)];
    const bool above_across = other == none ? s_.states[a] != below_level : part_above_[part_at_[other]] != 0;
    if (above_across) add({level_place::vert, a, a, a}, {level_place::vert, b, b, b});
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sorted = all;
  for (auto& [x, y] : sorted)
    if (y < x) std::swap(x, y);
  std::sort(sorted.begin(), sorted.end());
  for (const auto& [x, y] : all) {
    const auto same = std::equal_range(sorted.begin(), sorted.end(), std::minmax({x, y}));
    if ((same.second - same.first) % 2) cut_edges.push_back({x, y});
  }
}

}  // namespace concino::detail
