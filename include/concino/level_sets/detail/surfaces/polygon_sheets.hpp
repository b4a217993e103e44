// The polygons of a level set in a volume with their neighbours across edges, made a manifold.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/graph/disjoint_sets.hpp>
#include <concino/level_sets/detail/cut/level_place.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// A level set as polygons, counter-clockwise seen from above.
struct level_surface_arrays {
  std::vector<level_place> places;    // by vert
  std::vector<std::uint32_t> verts;   // the corners of all polygons
  std::vector<std::uint32_t> ends;    // by polygon: where its corners end
  std::vector<std::uint32_t> cells;   // by polygon: the number of the cell below or around it
};

/// Oriented polygons whose corners are places. Several polygons may have an edge between the same two places; which of
/// them are neighbours there is given. Polygons without size are removed, and verts are doubled once per fan.
class polygon_sheets {
 public:
  static constexpr std::uint32_t none = ~0u;

  /// Adds a corner to the current polygon. Returns its number, which is also that of the edge to the next corner.
  std::uint32_t add_corner(const level_place& x) {
    places_.push_back(numbers_.add(x));
    neighbours_.push_back(none);
    return num_corners() - 1;
  }
  std::uint32_t num_corners() const { return static_cast<std::uint32_t>(places_.size()); }
  /// Ends the current polygon, which is in or beside the cell with a number.
  void end_polygon(std::uint32_t cell) {
    ends_.push_back(num_corners());
    cells_.push_back(cell);
  }
  /// Says that two edges, which run in opposite directions, are the same.
  void make_neighbours(std::uint32_t a, std::uint32_t b) { neighbours_[a] = b, neighbours_[b] = a; }

  level_surface_arrays make();

 private:
  place_numbers numbers_;
  std::vector<std::uint32_t> places_, neighbours_;  // by corner; a neighbour is the corner where the same edge starts
                                                    // in another polygon
  std::vector<std::uint32_t> ends_, cells_;         // by polygon: where its corners end, and its cell
  std::vector<std::uint32_t> next_;                 // by corner: the next one in its polygon
  // those that have a size: their corners, where these end, their cells
  std::vector<std::uint32_t> polygons_, polygon_ends_, polygon_cells_;
  disjoint_sets fans_;

  void remove_polygons_without_size();
  level_surface_arrays number_fans();

  void remove_edge_pair(std::uint32_t a, std::uint32_t b);
  void add_loop(const std::uint32_t* first, const std::uint32_t* last, std::uint32_t cell);
  void remove_opposite_polygons();
  void unite_fans();
  bool separate_double_edges();
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/level_sets/detail/surfaces/polygon_sheets.ipp>
#endif
