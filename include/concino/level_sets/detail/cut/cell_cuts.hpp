// How a level set cuts the cells of a volume: chords of their facets, loops of chords, and the parts of each cell.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/graph/disjoint_sets.hpp>
#include <concino/level_sets/detail/cut/cell_surface.hpp>
#include <concino/level_sets/detail/cut/crossed_volume.hpp>
#include <concino/level_sets/detail/cut/level_place.hpp>
#include <concino/level_sets/detail/cut/polygon_crossings.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// The chords of the facets of a cell close to loops, each of which separates verts below from verts above. Connected
/// verts of one kind are a region. A region above without a vert strictly above is dropped: it counts as below, and its
/// loops do not cut the cell.
class cell_cuts {
 public:
  static constexpr std::uint32_t none = ~0u;
  // raised: it counts as above although its verts are below; see remove_flat_parts.hpp
  enum region_state : unsigned char { is_below, is_dropped, is_above, is_raised };

  struct chord {
    std::uint32_t from, to;  // corners: see level_chord
    std::uint32_t inner_begin, inner_end;
    std::uint32_t facet;
    std::uint32_t loop = none;
  };
  /// A loop, as its chords in the order in which they follow each other, counter-clockwise seen from above.
  struct loop {
    std::uint32_t first, last;  // in loop_chords
    std::uint32_t cell;
    bool cuts;
  };

  /// Whether all cells are known to have the surface of a sphere, as tets and hexes have.
  enum class cells_are { spheres, unknown };

  /// Errors: unsupported that names a cell whose surface is not a sphere.
  cell_cuts(const crossed_volume& v, cells_are surface, const char* caller,
            const std::vector<std::uint32_t>& cell_indices);

  const crossed_volume& volume() const { return v_; }
  const std::vector<chord>& chords() const { return chords_; }
  const std::vector<crossed_diagonal>& inner() const { return inner_; }  // as corners
  const std::vector<loop>& loops() const { return loops_; }
  const std::vector<std::uint32_t>& loop_chords() const { return loop_chords_; }
  std::uint32_t first_chord(std::uint32_t facet) const { return first_chord_[facet]; }
  // none at edges that are not crossed
  std::uint32_t chord_at(std::uint32_t corner) const { return chord_at_[corner]; }
  std::uint32_t cell_of(std::uint32_t facet) const { return cell_of_[facet]; }
  std::uint32_t facet_of(std::uint32_t corner) const { return facet_of_[corner]; }
  std::uint32_t next(std::uint32_t corner) const {
    return corner + 1 < v_.first_corner[facet_of_[corner] + 1] ? corner + 1 : v_.first_corner[facet_of_[corner]];
  }
  std::uint32_t previous(std::uint32_t corner) const {
    return corner > v_.first_corner[facet_of_[corner]] ? corner - 1 : v_.first_corner[facet_of_[corner] + 1] - 1;
  }
  /// The other facet of the same cell at an edge, as its corner there.
  std::uint32_t mate(std::uint32_t corner) const { return mates_[corner]; }
  /// The facet of the other crossed cell at the same face; none if there is none.
  std::uint32_t twin(std::uint32_t facet) const { return twins_[facet]; }
  /// Verts have a number for each of their cells. Regions are known by the smallest number of their verts.
  std::uint32_t num_cell_verts() const { return static_cast<std::uint32_t>(regions_.size()); }
  std::uint32_t number_in_cells(std::uint32_t corner) const { return cell_vert_[corner]; }
  std::uint32_t region(std::uint32_t corner) { return static_cast<std::uint32_t>(regions_.root(cell_vert_[corner])); }
  region_state state(std::uint32_t corner) { return static_cast<region_state>(region_states_[region(corner)]); }

  /// Whether the places of a chord are corners of parts: its loop cuts the cell, or that in the other cell at the face.
  bool is_active(std::uint32_t number) const;

  /// Makes a loop one that does not cut, and the region on one side of it count as the other one.
  void stop_cutting(std::uint32_t number) { loops_[number].cuts = false; }
  void change_region(std::uint32_t corner) {
    unsigned char& s = region_states_[region(corner)];
    s = s == is_above ? is_dropped : is_raised;
  }

  /// The place of the crossed edge that begins at a corner, and of a crossed diagonal of a facet.
  level_place crossing(std::uint32_t corner) const {
    return v_.place_between(level_place::edge, v_.edges[corner], v_.verts[corner], v_.verts[next(corner)]);
  }
  level_place crossing(std::uint32_t facet, const crossed_diagonal& d) const {
    return v_.place_between(level_place::inside, v_.faces[facet], d.below, d.above);
  }

  /// The corner where a chord starts, or ends, seen from outside the cell.
  std::uint32_t start(const chord& c) const { return v_.outward[c.facet] ? c.from : c.to; }
  std::uint32_t end(const chord& c) const { return v_.outward[c.facet] ? c.to : c.from; }

 private:
  const crossed_volume& v_;
  std::vector<std::uint32_t> facet_of_, cell_of_, mates_, twins_;
  std::vector<std::uint32_t> chord_at_, first_chord_, cell_vert_;
  std::vector<chord> chords_;
  std::vector<crossed_diagonal> inner_;
  std::vector<loop> loops_;
  std::vector<std::uint32_t> loop_chords_;
  disjoint_sets regions_;
  std::vector<unsigned char> region_states_;     // at the root of each region
  std::vector<unsigned char> cell_vert_states_;  // by number of a vert in a cell
  std::vector<std::uint32_t> seen_in_, number_in_cell_;  // by vert: the last cell that has it, and its number there

  void number_facets();
  bool find_mates(std::uint32_t cell, cells_are surface);
  void find_twins();
  void find_chords();
  void find_chords_of(std::uint32_t facet);
  void find_regions();
  void find_loops();
  cell_surface surface_;
  polygon_crossings crossings_;
  std::vector<unsigned char> above_;
  std::vector<double> values_;
  std::vector<vec3> points_;
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/level_sets/detail/cut/cell_cuts.ipp>
#endif
