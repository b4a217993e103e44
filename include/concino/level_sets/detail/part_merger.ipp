// Joins the parts of simple cells and those of difficult ones; see part_merger.hpp.
#pragma once

#include <concino/core/large_pages.hpp>
#include <concino/level_sets/detail/part_merger.hpp>

#include <algorithm>

namespace concino::detail {

CONCINO_INLINE void part_merger::reserve() {
  const std::size_t sides = both_ ? 2 : 1, num_cells = cells_.cells_.size(), num_uses = sides * (cells_.entries_.size() + num_cells);
  core::reserve_pages(lists.faces, sides * cells_.num_crossed_ + num_cells);
  core::reserve_pages(lists.face_places, cells_.num_crossed_corners_ + sides * 2 * cells_.num_crossed_ + cells_.caps_.size());
  core::reserve_pages(lists.parts, sides * num_cells);
  core::reserve_pages(lists.part_faces, num_uses), core::reserve_pages(lists.outward, num_uses);
}

CONCINO_INLINE void part_merger::number_place(std::uint32_t place) {
  if (!cut_ || (place & of_mesh)) return;
  if (std::uint32_t& number = final_places_[place]; number == none) number = num_places_++;
}
CONCINO_INLINE void part_merger::add_place(std::uint32_t place) {
  number_place(place);
  lists.face_places.push_back(cut_ && !(place & of_mesh) ? final_places_[place] : place);
}

CONCINO_INLINE void part_merger::end_face(std::uint32_t origin, bool is_whole, bool is_cut) {
  const std::uint32_t first = lists.faces.empty() ? 0 : lists.faces.back().last;
  lists.faces.push_back({first, static_cast<std::uint32_t>(lists.face_places.size()), origin, is_whole, is_cut});
}

/// Lists the polygons on the wanted sides of a crossed face: that of the first corner comes first.
CONCINO_INLINE void part_merger::list_simple(const simple_cells::face& f) {
  const std::uint32_t *const corners = cells_.corners_.data() + f.first_corner, n = f.last_corner - f.first_corner;
  if (both_ || f.starts_above) {
    for (std::uint32_t k = 0; k <= f.ends[0]; ++k) add_place(of_mesh | corners[k]);
    add_place(f.places[0]), add_place(f.places[1]);
    for (std::uint32_t k = f.ends[1] + 1; k < n; ++k) add_place(of_mesh | corners[k]);
    end_face(f.index, false, false);
  }
  if (both_ || !f.starts_above) {
    number_place(f.places[0]);  // as by the other polygon, which comes first
    for (std::uint32_t k = f.ends[0] + 1; k <= f.ends[1]; ++k) add_place(of_mesh | corners[k]);
    add_place(f.places[1]), add_place(f.places[0]);
    end_face(f.index, false, false);
  }
}

CONCINO_INLINE void part_merger::list_cut(std::uint32_t number) {
  const part_lists::face& f = cut_->faces[number];
  numbers_of_cut_[number] = static_cast<std::uint32_t>(lists.faces.size());
  for (std::uint32_t k = f.first; k < f.last; ++k) add_place(places_of_cut_[cut_->face_places[k]]);
  end_face(f.origin, f.is_whole, f.is_cut);
}

/// Whether a face of a difficult cell is also a crossed one of a simple cell.
CONCINO_INLINE bool part_merger::is_beside_simple(const simple_cells::face& f) {
  return f.is_crossed && f.is_simple && f.num_difficult == 1 && f.polys[1] != none;
}

/// Whether a face belongs to simple cells alone.
CONCINO_INLINE bool part_merger::is_between_simple(std::uint32_t face) const {
  return face != none && cells_.faces_[cells_.number_of_[face]].num_difficult == 0;
}

/// Both cell_parts and simple_cells number faces in the order in which cells have them.
CONCINO_INLINE bool part_merger::list_faces() {
  const std::size_t num_cut = cut_ ? cut_->faces.size() : 0;
  std::uint32_t next = 0, next_place = 0;
  for (std::size_t i = 0; i < cells_.faces_.size(); ++i) {
    const simple_cells::face& f = cells_.faces_[i];
    numbers_[i] = static_cast<std::uint32_t>(lists.faces.size());
    if (f.num_difficult == 0) {
      if (f.is_crossed) list_simple(f);
      continue;
    }
    while (next_place < places_of_cut_.size() && is_between_simple(cut_->first_faces[next_place])) ++next_place;
    for (; next_place < places_of_cut_.size() && cut_->first_faces[next_place] == f.index; ++next_place) number_place(places_of_cut_[next_place]);
    while (next < num_cut && is_between_simple(cut_->faces[next].origin)) ++next;
    for (; next < num_cut && cut_->faces[next].origin == f.index; ++next) list_cut(next);
    const std::size_t n = lists.faces.size() - numbers_[i];
    if (n == 0 || (is_beside_simple(f) && n != 2)) return false;
  }
  return true;
}

CONCINO_INLINE void part_merger::list_caps() {
  std::vector<std::uint32_t> cell_of_cap;  // by face of cut_
  if (cut_) {
    cell_of_cap.assign(cut_->faces.size(), none);
    for (const part_lists::part& p : cut_->parts)
      for (std::uint32_t k = p.first; k < p.last; ++k)
        if (const std::uint32_t f = cut_->part_faces[k]; cut_->faces[f].origin == none && cell_of_cap[f] == none) cell_of_cap[f] = cut_cells_[p.cell];
  }
  caps_ = core::large_vector(cells_.cells_.size(), none);
  std::uint32_t next = 0;
  for (std::uint32_t c = 0; c < cells_.cells_.size(); ++c) {
    const simple_cells::cell& x = cells_.cells_[c];
    if (x.is_difficult) {
      while (next < cell_of_cap.size() && (cell_of_cap[next] == none || cell_of_cap[next] < c)) ++next;
      for (; next < cell_of_cap.size() && (cell_of_cap[next] == none || cell_of_cap[next] == c); ++next)
        if (cell_of_cap[next] == c) list_cut(next);
      continue;
    }
    caps_[c] = static_cast<std::uint32_t>(lists.faces.size());
    for (std::uint32_t k = x.first_cap; k < x.last_cap; ++k) add_place(cells_.caps_[k]);
    end_face(none, false, true);
  }
}

CONCINO_INLINE void part_merger::list_simple_part(std::uint32_t number, bool above) {
  const simple_cells::cell& c = cells_.cells_[number];
  const auto first = static_cast<std::uint32_t>(lists.part_faces.size());
  const auto add = [&](std::uint32_t x, bool outward) { lists.part_faces.push_back(x), lists.outward.push_back(outward); };
  for (std::uint32_t i = c.first_entry; i < c.last_entry; ++i) {
    const simple_cells::entry& e = cells_.entries_[i];
    const simple_cells::face& f = cells_.faces_[e.face];
    if (f.is_crossed) add(numbers_[e.face] + ((both_ || f.num_difficult > 0) && f.starts_above != above), e.outward);
    else if (f.starts_above == above) add(of_mesh | f.index, e.outward);
  }
  add(caps_[number], !above);
  lists.parts.push_back({number, first, static_cast<std::uint32_t>(lists.part_faces.size()), above, false});
}

/// Returns false if a face is one that only simple cells should have.
CONCINO_INLINE bool part_merger::list_cut_part(const part_lists::part& p, std::uint32_t number) {
  const auto first = static_cast<std::uint32_t>(lists.part_faces.size());
  for (std::uint32_t k = p.first; k < p.last; ++k) {
    const std::uint32_t f = numbers_of_cut_[cut_->part_faces[k]];
    if (f == none) return false;
    lists.part_faces.push_back(f);
    lists.outward.push_back(cut_->outward[k]);
  }
  lists.parts.push_back({number, first, static_cast<std::uint32_t>(lists.part_faces.size()), p.is_above, p.is_whole});
  return true;
}

/// Whether each polygon between a simple cell and a difficult one belongs to both, and to no other cell.
CONCINO_INLINE bool part_merger::are_used_twice() const {
  std::vector<std::uint32_t> num_uses(cut_->faces.size(), 0);
  for (const std::uint32_t f : cut_->part_faces) ++num_uses[f];
  for (std::uint32_t i = 0; i < num_uses.size(); ++i) {
    const std::uint32_t origin = cut_->faces[i].origin;
    if (numbers_of_cut_[i] == none || origin == none) continue;
    const simple_cells::face& f = cells_.faces_[cells_.number_of_[origin]];
    if (is_beside_simple(f) && num_uses[i] != 2) return false;
  }
  return true;
}

CONCINO_INLINE bool part_merger::list() {
  reserve();
  if (!list_faces() || (cut_ && !are_used_twice())) return false;
  list_caps();
  std::size_t next = 0;
  for (std::uint32_t c = 0; c < cells_.cells_.size(); ++c) {
    if (cells_.cells_[c].is_difficult) {
      while (next < cut_->parts.size() && cut_cells_[cut_->parts[next].cell] < c) ++next;
      for (; next < cut_->parts.size() && cut_cells_[cut_->parts[next].cell] == c; ++next)
        if (!list_cut_part(cut_->parts[next], c)) return false;
      continue;
    }
    const bool first = cells_.cells_[c].starts_above;  // the part with the first corner of the cell comes first
    if (both_ || first) list_simple_part(c, first);
    if (both_ || !first) list_simple_part(c, !first);
  }
  return true;
}

}  // namespace concino::detail
