// Adds simple cells behind others; see simple_cells.hpp.
#pragma once

#include <concino/core/large_pages.hpp>
#include <concino/level_sets/detail/simple_cells.hpp>

namespace concino::detail {

/// Adds the faces of others that are not here. Result: by face of others, its number here.
CONCINO_INLINE std::vector<std::uint32_t> simple_cells::append_faces(const simple_cells& others, std::span<const std::uint32_t> places) {
  std::vector<std::uint32_t> numbers;
  core::reserve_pages(numbers, others.faces_.size());
  core::reserve_large(faces_, faces_.size() + others.faces_.size()), core::reserve_large(keys_, keys_.size() + others.faces_.size());
  core::reserve_large(corners_, corners_.size() + others.corners_.size());
  for (const face& x : others.faces_) {
    std::uint32_t& number = number_of_[x.index];
    numbers.push_back(number == none ? static_cast<std::uint32_t>(faces_.size()) : number);
    if (number != none) {
      faces_[number].num_difficult = static_cast<unsigned char>(faces_[number].num_difficult + x.num_difficult);
      continue;
    }
    number = numbers.back();
    faces_.push_back(x);
    face& f = faces_.back();
    f.first_corner = static_cast<std::uint32_t>(corners_.size());
    corners_.insert(corners_.end(), others.corners_.begin() + x.first_corner, others.corners_.begin() + x.last_corner);
    f.last_corner = static_cast<std::uint32_t>(corners_.size());
    if (f.is_crossed) ++num_crossed_, num_crossed_corners_ += f.last_corner - f.first_corner;
    if (!f.is_simple) continue;
    if (f.is_crossed)
      for (std::uint32_t& place : f.places) place = places[place];
    keys_.push_back(key_of(f));
  }
  return numbers;
}

CONCINO_INLINE std::vector<std::uint32_t> simple_cells::append(const simple_cells& others, std::span<const std::uint32_t> places) {
  const auto num_faces = static_cast<std::uint32_t>(faces_.size()), first_entry = static_cast<std::uint32_t>(entries_.size()), first_cap = static_cast<std::uint32_t>(caps_.size());
  const std::vector<std::uint32_t> numbers = append_faces(others, places);
  core::reserve_large(entries_, entries_.size() + others.entries_.size()), core::reserve_large(caps_, caps_.size() + others.caps_.size());
  core::reserve_large(cells_, cells_.size() + others.cells_.size());
  for (const entry& e : others.entries_) entries_.push_back({numbers[e.face], e.outward});
  for (const std::uint32_t place : others.caps_) caps_.push_back(places[place]);
  std::vector<std::uint32_t> with_common_faces;
  for (std::uint32_t i = 0; i < others.cells_.size(); ++i) {
    cell c = others.cells_[i];
    c.first_entry += first_entry, c.last_entry += first_entry, c.first_cap += first_cap, c.last_cap += first_cap;
    bool is_beside = false;
    for (std::uint32_t k = c.first_entry; k < c.last_entry; ++k) is_beside = is_beside || entries_[k].face < num_faces;
    if (is_beside) {
      sort_entries(c);
      with_common_faces.push_back(i);
    }
    cells_.push_back(c);
  }
  return with_common_faces;
}

}  // namespace concino::detail
