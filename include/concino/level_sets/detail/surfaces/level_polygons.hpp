// The polygons of a level set in the cells of a volume.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/level_sets/detail/cut/cell_cuts.hpp>
#include <concino/level_sets/detail/surfaces/polygon_sheets.hpp>

#include <cstdint>
#include <vector>

namespace concino::detail {

/// Adds the facets between a part below and a part above to a list: caps of loops, and parts of faces on the level set.
class level_polygons {
  static constexpr std::uint32_t none = ~0u;

  cell_cuts& cuts_;
  const crossed_volume& v_;
  polygon_sheets& sheets_;
  std::vector<std::uint32_t> first_segment_;    // by chord, common to both sides of a face
  std::vector<std::uint32_t> segment_user_;     // by segment of a chord: the corner of sheets_ that uses it first
  std::vector<std::uint32_t> edge_user_;        // by corner of a facet: the corner of sheets_ that uses the edge from
                                                // there
  std::vector<unsigned char> has_facet_;        // by corner of a facet: whether the part of the facet at its vert is in
                                                // the level set

 public:
  level_polygons(cell_cuts& cuts, polygon_sheets& sheets) : cuts_(cuts), v_(cuts.volume()), sheets_(sheets) {}

  void add_all();

 private:
  void number_segments();
  void use_segment(std::uint32_t segment, std::uint32_t corner);
  void add_chord(std::uint32_t chord, bool to_end);
  void add_cap(const cell_cuts::loop& loop);
  void find_facets();
  void add_facet(std::uint32_t corner, std::vector<unsigned char>& is_done);
  void link_edges();
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/level_sets/detail/surfaces/level_polygons.ipp>
#endif
