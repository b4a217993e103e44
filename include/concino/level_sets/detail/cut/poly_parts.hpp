// The parts into which a level set cuts polygons.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/local_numbers.hpp>
#include <concino/level_sets/detail/cut/chord_places.hpp>
#include <concino/level_sets/detail/cut/level_place.hpp>
#include <concino/level_sets/detail/cut/poly_cuts.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace concino::detail {

/// The parts of all polys of poly_cuts. Polys that are left whole have one part.
class poly_parts {
 public:
  static constexpr std::uint32_t none = ~0u;

  struct part {
    std::uint32_t poly;
    std::uint32_t first, last;  // in part_places
    bool is_above;
    bool is_whole;              // it is the whole poly
  };

  std::vector<part> parts;                 // by poly
  std::vector<std::uint32_t> part_places;  // places, by number, in the direction of the poly
  std::vector<level_place> places;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> cut_edges;  // edges between a part below and a part above, by
                                                                   // their places
  std::vector<std::uint32_t> moved_verts;  // verts that count as on the other side; see remove_flat_chords()

  explicit poly_parts(poly_cuts& cuts);

 private:
  poly_cuts& cuts_;
  const crossed_surface& s_;
  place_numbers numbers_;
  core::local_numbers added_edges_;        // edges of the mesh that get a vert, if not all crossed ones do
  enum : unsigned char { not_moved, moved_above, moved_below };
  std::vector<unsigned char> is_moved_;    // by corner: it counts as on the other side of its part
  std::vector<std::uint32_t> part_at_;     // by corner: its part, before parts without size are removed
  std::vector<unsigned char> part_above_;  // by such a part
  std::vector<std::uint32_t> polygon_, open_, position_;

  void remove_flat_chords();
  bool change(poly_cuts::chord& a, poly_cuts::chord& b, bool above);
  std::vector<std::uint32_t> corners_of_part(const poly_cuts::chord& c, bool above) const;
  bool is_segment(const poly_cuts::chord& c) const;
  void find_added_edges();
  void add_part(std::uint32_t corner);
  void add_polygons(std::uint32_t poly, bool is_above, bool is_whole);
  void add_place(const level_place& x) { polygon_.push_back(numbers_.add(x)); }
  void find_cut_edges();
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/level_sets/detail/cut/poly_parts.ipp>
#endif
