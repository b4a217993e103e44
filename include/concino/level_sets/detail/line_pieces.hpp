// The level set of a function on a surface: pieces in the polys that it crosses, and how they are joined to lines.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/level_sets/detail/level_place.hpp>
#include <concino/level_sets/detail/polygon_crossings.hpp>

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

/// Lines, one after another. Line i has the places from ends[i - 1] to ends[i].
struct level_lines {
  std::vector<level_place> places;
  std::vector<std::size_t> ends;
  std::vector<unsigned char> closed;
};

/// The pieces of a level set are chords of polys, and edges on the level set between a part below and a part above. A part of a poly without a vert
/// strictly above counts as below.
class line_pieces {
  static constexpr std::uint32_t none = ~0u;
  enum corner_state : unsigned char { is_below, is_dropped, is_above };  // dropped: on the level set, in a part without verts above

  struct chord {
    std::uint32_t from, to;  // corners: see level_chord
    std::uint32_t inner_begin, inner_end;
    std::uint32_t piece;     // or none, if it is dropped
  };
  struct piece {
    std::uint32_t chord;   // or none
    std::uint32_t corner;  // of an edge: its first corner in the poly below
    std::uint32_t link[2] = {none, none};  // what follows at the start and at the end: 2 piece + (0 at the start of that piece, 1 at its end)
  };

  const crossed_surface& s_;
  double level_;
  std::vector<std::uint32_t> poly_of_;      // by corner
  std::vector<unsigned char> state_;        // by corner
  std::vector<std::uint32_t> chord_at_;     // by corner, at crossed edges
  std::vector<std::uint32_t> piece_at_;     // by corner, at edges on the level set
  std::vector<std::uint32_t> uses_;         // two corners of each edge
  std::vector<chord> chords_;
  std::vector<crossed_diagonal> inner_;     // as corners
  std::vector<piece> pieces_;
  std::vector<unsigned char> is_joined_;

 public:
  line_pieces(const crossed_surface& s, double level);

  /// Joins the pieces: in the order of their first polys, with larger values to the left of the first piece.
  level_lines join();

 private:
  std::uint32_t num_corners() const { return static_cast<std::uint32_t>(s_.verts.size()); }
  std::uint32_t next(std::uint32_t c) const { return c + 1 < s_.first_corner[poly_of_[c] + 1] ? c + 1 : s_.first_corner[poly_of_[c]]; }
  std::uint32_t previous(std::uint32_t c) const { return c > s_.first_corner[poly_of_[c]] ? c - 1 : s_.first_corner[poly_of_[c] + 1] - 1; }
  std::uint32_t other_use(std::uint32_t c) const;

  void find_chords();
  void find_states(std::uint32_t poly);
  void make_pieces();
  void link_pieces();
  std::uint32_t follow(std::uint32_t piece, unsigned end) const;
  std::uint32_t follow_chord(std::uint32_t corner) const;
  std::uint32_t rotate(std::uint32_t corner, std::uint32_t vert) const;
  std::uint32_t edge_beside(std::uint32_t corner, std::uint32_t vert) const;

  void append(level_lines& lines, std::uint32_t piece, bool forward) const;
  void add_place(level_lines& lines, const level_place& x) const;
  void end_line(level_lines& lines, bool closed) const;
  level_place place_on_edge(std::uint32_t corner) const;
  level_place place_between(level_place::kind_type kind, std::uint32_t element, std::uint32_t below, std::uint32_t above) const;
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/level_sets/detail/line_pieces.ipp>
#endif
