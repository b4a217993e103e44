// Polygons with their neighbours across edges, made a manifold: polygons without size are removed, and verts are doubled once per fan.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/graph/disjoint_sets.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Oriented polygons whose corners are places, by number. Several polygons may have an edge between the same two places; which of them are neighbours there is
/// given.
class polygon_sheets {
 public:
  static constexpr std::uint32_t none = ~0u;

  // By corner: its place, and the corner in another polygon from which the same edge starts in the opposite direction.
  std::vector<std::uint32_t> places, neighbours;
  std::vector<std::uint32_t> ends;  // by polygon: where its corners end

  void add_corner(std::uint32_t place) {
    places.push_back(place);
    neighbours.push_back(none);
  }
  void end_polygon() { ends.push_back(static_cast<std::uint32_t>(places.size())); }
  void make_neighbours(std::uint32_t a, std::uint32_t b) { neighbours[a] = b, neighbours[b] = a; }

  /// Joins equal corners that follow each other, cuts polygons that come twice to one place, and removes those that have fewer than three corners left, or
  /// the corners of another one in opposite order. The neighbours of what is removed become neighbours of each other.
  /// Result: `polygons`, and `polygon_origins`, the numbers of the polygons of which they were made.
  void remove_polygons_without_size();

  /// Numbers the corners of `polygons` such that the surface is a manifold: corners have equal numbers if they are at one place and in one fan of
  /// neighbours. No two numbers are joined by two edges.
  /// Result: the place of each number.
  std::vector<std::uint32_t> number_fans();

  /// The corners of polygons; by polygon, where they end; after number_fans() their numbers.
  std::vector<std::uint32_t> polygons, polygon_ends, polygon_origins, numbers;

 private:
  std::vector<std::uint32_t> next_;  // by corner: the next one in its polygon
  disjoint_sets fans_;

  void remove_edge_pair(std::uint32_t a, std::uint32_t b);
  void add_loop(const std::uint32_t* first, const std::uint32_t* last, std::uint32_t origin);
  void remove_opposite_polygons();
  void unite_fans();
  bool separate_double_edges();
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/level_sets/detail/polygon_sheets.ipp>
#endif
