// The parts into which a level set cuts cells; see cell_parts.hpp.
#pragma once

#include <concino/level_sets/detail/cut/cell_parts.hpp>
#include <concino/level_sets/detail/cut/level_states.hpp>
#include <concino/level_sets/detail/cut/remove_flat_parts.hpp>

namespace concino::detail {

CONCINO_INLINE cell_parts::cell_parts(cell_cuts& cuts) : cuts_(cuts), v_(cuts.volume()) {
  moved_verts = remove_flat_parts(cuts_);
  join_regions();
  find_added_edges();
  // A face of two cells, cut in two, and a cap in each cell: about as many as facets.
  const std::size_t num_facets = v_.num_facets();
  faces.reserve(num_facets + num_facets / 2), uses_.reserve(2 * num_facets),
      face_places.reserve(v_.num_corners() + v_.num_corners() / 2);
  add_facets();
  add_caps();
  merge_equal_faces();
  list_parts();
  places = std::move(numbers_.places);
}

/// Joins the regions on both sides of each loop that does not cut. A part is above if one of its regions is, or is
/// raised.
CONCINO_INLINE void cell_parts::join_regions() {
  part_of_ = disjoint_sets(cuts_.num_cell_verts());
  for (const cell_cuts::loop& l : cuts_.loops()) {
    const cell_cuts::chord& c = cuts_.chords()[cuts_.loop_chords()[l.first]];
    if (!l.cuts) part_of_.unite(cuts_.region(c.from), cuts_.region(c.to));
  }
  is_above_.assign(cuts_.num_cell_verts(), 0);
  for (std::uint32_t k = 0; k < v_.num_corners(); ++k) {
    const cell_cuts::region_state s = cuts_.state(k);
    if (s == cell_cuts::is_above || s == cell_cuts::is_raised) is_above_[part_at(k)] = 1;
  }
}

/// A crossed edge gets a vert unless its place is a vert, or no chord that ends there is a boundary of parts.
CONCINO_INLINE void cell_parts::find_added_edges() {
  all_crossed_ = moved_verts.empty();
  if (all_crossed_) return;
  for (std::uint32_t i = 0; i < cuts_.chords().size(); ++i) {
    if (!cuts_.is_active(i)) continue;
    added_edges_.add(v_.edges[cuts_.chords()[i].from]);
    added_edges_.add(v_.edges[cuts_.chords()[i].to]);
  }
}
CONCINO_INLINE bool cell_parts::is_added(std::uint32_t corner) const {
  if (cuts_.chord_at(corner) == none || cuts_.crossing(corner).kind == level_place::vert) return false;
  return all_crossed_ || added_edges_.find(v_.edges[corner]) != core::local_numbers::none;
}
CONCINO_INLINE void cell_parts::add_crossing_if_added(std::uint32_t corner) {
  if (is_added(corner)) add_place(cuts_.crossing(corner));
}

/// Adds the places of a chord from one end to the other.
CONCINO_INLINE void cell_parts::add_chord(std::uint32_t chord, bool forward) {
  const cell_cuts::chord& c = cuts_.chords()[chord];
  const std::uint32_t n = c.inner_end - c.inner_begin;
  add_place(cuts_.crossing(forward ? c.from : c.to));
  for (std::uint32_t k = 0; k < n; ++k)
    add_place(cuts_.crossing(c.facet, cuts_.inner()[forward ? c.inner_begin + k : c.inner_end - 1 - k]));
  add_place(cuts_.crossing(forward ? c.to : c.from));
}

/// Adds the parts of each face once, for the cells on both sides of it.
CONCINO_INLINE void cell_parts::add_facets() {
  std::vector<unsigned char> is_done(v_.num_corners(), 0);
  for (std::uint32_t s = 0; s < v_.num_facets(); ++s) {
    if (const std::uint32_t fan = v_.fan_of[s]; fan != none) {
      const crossed_volume::fan& f = v_.fans[fan];
      bool any = false;
      for (std::uint32_t i = cuts_.first_chord(f.first_facet); i < cuts_.first_chord(f.last_facet); ++i)
        any = any || cuts_.is_active(i);
      if (!any) {
        if (s == f.first_facet) add_fan(fan);
        continue;
      }
    }
    if (cuts_.twin(s) >= s) add_facet(s, is_done);
  }
}

CONCINO_INLINE void cell_parts::add_facet(std::uint32_t facet, std::vector<unsigned char>& is_done) {
  const std::uint32_t first = v_.first_corner[facet], last = v_.first_corner[facet + 1];
  for (std::uint32_t corner = first; corner < last; ++corner) {
    if (is_done[corner]) continue;
    polygon_.clear();
    bool is_whole = v_.fan_of[facet] == none;
    for (std::uint32_t k = corner; !is_done[k];) {
      is_done[k] = 1;
      const std::uint32_t v = v_.verts[k], chord = cuts_.chord_at(k);
      add_place({level_place::vert, v, v, v});
      if (chord == none || !cuts_.is_active(chord)) {
        const std::size_t before = polygon_.size();
        add_crossing_if_added(k);
        is_whole = is_whole && polygon_.size() == before;
        k = cuts_.next(k);
        continue;
      }
      is_whole = false;
      const cell_cuts::chord& c = cuts_.chords()[chord];
      add_chord(chord, c.from == k);
      k = cuts_.next(c.from == k ? c.to : c.from);
    }
    add_piece(corner, v_.faces[facet], is_whole);
  }
}

/// Adds a face that no chord cuts although it was replaced by triangles.
CONCINO_INLINE void cell_parts::add_fan(std::uint32_t fan) {
  const crossed_volume::fan& f = v_.fans[fan];
  polygon_.clear();
  bool is_whole = true;
  for (std::uint32_t s = f.first_facet; s < f.last_facet; ++s) {
    const std::uint32_t corner = v_.first_corner[s], v = v_.verts[corner];
    add_place({level_place::vert, v, v, v});
    const std::size_t before = polygon_.size();
    add_crossing_if_added(corner);
    is_whole = is_whole && polygon_.size() == before;
  }
  add_piece(v_.first_corner[f.first_facet], v_.faces[f.first_facet], is_whole);
}

/// Adds the current polygon as a face of the part at a corner, and of the part on the other side.
CONCINO_INLINE void cell_parts::add_piece(std::uint32_t corner, std::uint32_t face_index, bool is_whole) {
  const std::uint32_t facet = cuts_.facet_of(corner), twin = cuts_.twin(facet), here = part_at(corner);
  const std::uint32_t across = twin == none ? none : part_at(corner - v_.first_corner[facet] + v_.first_corner[twin]);
  // A cell across that is not crossed is above if it has a vert above.
  const bool above_across = across != none ? is_above_[across] != 0 : v_.states[v_.verts[corner]] != below_level;
  const bool is_cut = v_.num_polys[facet] == 2 && above_across != (is_above_[here] != 0);
  const auto first = static_cast<std::uint32_t>(faces.size()), n = add_faces(face_index, is_whole, is_cut);
  for (std::uint32_t i = first; i < first + n; ++i) {
    uses_.push_back({here, i, v_.outward[facet] != 0});
    if (across != none) uses_.push_back({across, i, v_.outward[twin] != 0});
  }
}

CONCINO_INLINE void cell_parts::add_caps() {
  for (const cell_cuts::loop& l : cuts_.loops()) {
    if (!l.cuts) continue;
    polygon_.clear();
    for (std::uint32_t k = l.first; k < l.last; ++k) {
      const std::uint32_t chord = cuts_.loop_chords()[k];
      add_chord(chord, cuts_.start(cuts_.chords()[chord]) == cuts_.chords()[chord].from);
    }
    const cell_cuts::chord& c = cuts_.chords()[cuts_.loop_chords()[l.first]];
    const auto first = static_cast<std::uint32_t>(faces.size()), n = add_faces(none, false, true);
    for (std::uint32_t i = first; i < first + n; ++i) {
      uses_.push_back({part_at(c.to), i, true});
      uses_.push_back({part_at(c.from), i, false});
    }
  }
}

/// Adds the current polygon: equal places that follow each other are joined, and a polygon that comes to one place
/// twice is cut there. Returns how many polygons with three places or more are left.
CONCINO_INLINE std::uint32_t cell_parts::add_faces(std::uint32_t origin, bool is_whole, bool is_cut) {
  const std::size_t before = faces.size();
  const auto add = [&](std::size_t first) {
    if (open_.size() - first > 2) {
      const auto start = static_cast<std::uint32_t>(face_places.size());
      face_places.insert(face_places.end(), open_.begin() + static_cast<std::ptrdiff_t>(first), open_.end());
      faces.push_back({start, static_cast<std::uint32_t>(face_places.size()), origin, is_whole, is_cut});
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
  return static_cast<std::uint32_t>(faces.size() - before);
}

}  // namespace concino::detail
