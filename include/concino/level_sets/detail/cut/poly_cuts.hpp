// How a level set cuts the polys of a surface: chords and the parts of each poly.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/level_sets/detail/cut/level_place.hpp>
#include <concino/level_sets/detail/cut/polygon_crossings.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// The polys of a surface that a level set crosses, in flat arrays. Verts and edges have numbers from 0.
struct crossed_surface {
  std::vector<std::uint32_t> first_corner{0};  // by poly, one more than there are polys
  std::vector<std::uint32_t> verts, edges;     // by corner; edge k of a poly joins its corners k and k + 1
  std::vector<unsigned char> num_polys;        // by edge, in the whole surface; 3 means 3 or more
  std::vector<std::uint32_t> vert_indices;     // by vert
  std::vector<vec3> points;
  std::vector<double> values;
  std::vector<unsigned char> states;           // see level_states.hpp

  std::uint32_t size() const { return static_cast<std::uint32_t>(first_corner.size() - 1); }
};

/// Each chord separates a part of its poly above from one below. A part above without a vert strictly above is dropped:
/// it counts as below, and its chords do not cut the poly.
class poly_cuts {
 public:
  static constexpr std::uint32_t none = ~0u;
  enum corner_state : unsigned char { is_below, is_dropped, is_above };

  struct chord {
    std::uint32_t from, to;  // corners: see level_chord
    std::uint32_t inner_begin, inner_end;
    std::uint32_t poly;
    bool cuts;
  };

  poly_cuts(const crossed_surface& s, double level);

  const crossed_surface& surface() const { return s_; }
  std::uint32_t num_corners() const { return static_cast<std::uint32_t>(s_.verts.size()); }
  std::uint32_t poly_of(std::uint32_t c) const { return poly_of_[c]; }
  std::uint32_t next(std::uint32_t c) const {
    return c + 1 < s_.first_corner[poly_of_[c] + 1] ? c + 1 : s_.first_corner[poly_of_[c]];
  }
  std::uint32_t previous(std::uint32_t c) const {
    return c > s_.first_corner[poly_of_[c]] ? c - 1 : s_.first_corner[poly_of_[c] + 1] - 1;
  }
  /// The corner of the same edge in the only other poly at it; none if there is none, or if it is not crossed.
  std::uint32_t other_use(std::uint32_t c) const;
  corner_state state(std::uint32_t c) const { return static_cast<corner_state>(state_[c]); }
  std::vector<chord>& chords() { return chords_; }
  const std::vector<chord>& chords() const { return chords_; }
  std::uint32_t chord_at(std::uint32_t c) const { return chord_at_[c]; }  // none at edges that are not crossed

  /// The place of the crossed edge that begins at a corner, and of a diagonal that a chord crosses.
  level_place crossing(std::uint32_t corner) const;
  level_place crossing(const chord& c, std::uint32_t inner) const;

 private:
  level_place place_between(level_place::kind_type kind, std::uint32_t element, std::uint32_t below,
                            std::uint32_t above) const;
  void find_chords(double level);
  void find_states(std::uint32_t poly);

  const crossed_surface& s_;
  std::vector<std::uint32_t> poly_of_;   // by corner
  std::vector<unsigned char> state_;     // by corner
  std::vector<std::uint32_t> chord_at_;  // by corner, at crossed edges
  std::vector<std::uint32_t> uses_;      // two corners of each edge
  std::vector<chord> chords_;
  std::vector<crossed_diagonal> inner_;  // as corners
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/level_sets/detail/cut/poly_cuts.ipp>
#endif
