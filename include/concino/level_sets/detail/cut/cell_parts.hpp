// The parts into which a level set cuts cells, as polyhedra with common faces.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/local_numbers.hpp>
#include <concino/level_sets/detail/cut/cell_cuts.hpp>
#include <concino/level_sets/detail/cut/level_place.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// The parts of all cells of cell_cuts. Cells that are left whole have one part.
class cell_parts {
 public:
  static constexpr std::uint32_t none = ~0u;

  struct face {
    std::uint32_t first, last;  // in face_places
    std::uint32_t origin;       // the index of the face of the mesh of which it is a part; none for the cap of a loop
    bool is_whole;              // it is that face
    bool is_cut;                // it is between a part below and a part above
  };
  struct part {
    std::uint32_t cell;
    std::uint32_t first, last;  // in part_faces
    bool is_above;
    bool is_whole;              // it is the whole cell, whose faces are all whole
  };

  std::vector<face> faces;
  std::vector<std::uint32_t> face_places;  // places, by number
  std::vector<part> parts;                 // by cell
  std::vector<std::uint32_t> part_faces;   // faces, by number
  std::vector<unsigned char> outward;      // by entry of part_faces: whether the places are counter-clockwise seen from
                                           // outside the part
  std::vector<level_place> places;
  std::vector<std::uint32_t> moved_verts;  // verts that count as on the other side; see remove_flat_parts()

  explicit cell_parts(cell_cuts& cuts);

 private:
  // One side of a polygon: a part, known by a number of one of its verts in its cell, uses it as a face.
  struct use {
    std::uint32_t part, face;
    bool outward;
  };

  cell_cuts& cuts_;
  const crossed_volume& v_;
  place_numbers numbers_;
  core::local_numbers added_edges_;       // edges of the mesh that get a vert, if not all crossed ones do
  bool all_crossed_ = true;
  disjoint_sets part_of_;                 // regions joined where no loop cuts
  std::vector<unsigned char> is_above_;   // by root of part_of_
  std::vector<std::uint32_t> polygon_;    // places of the current polygon
  std::vector<std::uint32_t> open_, position_;
  std::vector<use> uses_;

  void join_regions();
  void find_added_edges();
  bool is_added(std::uint32_t corner) const;
  std::uint32_t part_at(std::uint32_t corner) {
    return static_cast<std::uint32_t>(part_of_.root(cuts_.region(corner)));
  }
  void add_place(const level_place& x) { polygon_.push_back(numbers_.add(x)); }
  void add_crossing_if_added(std::uint32_t corner);
  void add_chord(std::uint32_t chord, bool forward);
  void add_facets();
  void add_facet(std::uint32_t facet, std::vector<unsigned char>& is_done);
  void add_fan(std::uint32_t fan);
  void add_piece(std::uint32_t corner, std::uint32_t face_index, bool is_whole);
  void add_caps();
  std::uint32_t add_faces(std::uint32_t origin, bool is_whole, bool is_cut);
  void merge_equal_faces();
  int compare_places(const face& a, const face& b) const;
  void list_parts();
  std::size_t end_of_piece(std::vector<use>& uses, std::size_t first);
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/level_sets/detail/cut/cell_part_faces.ipp>
#include <concino/level_sets/detail/cut/cell_parts.ipp>
#include <concino/level_sets/detail/cut/cell_pieces.ipp>
#endif
