// The level set of a function on a surface: pieces in the polys that it crosses, and how they are joined to lines.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/level_sets/detail/level_place.hpp>
#include <concino/level_sets/detail/poly_cuts.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Lines, one after another. Line i has the places from ends[i - 1] to ends[i].
struct level_lines {
  std::vector<level_place> places;
  std::vector<std::size_t> ends;
  std::vector<unsigned char> closed;
};

/// The pieces of a level set are the chords that cut polys, and edges on the level set between a part below and a part above.
class line_pieces {
  static constexpr std::uint32_t none = ~0u;

  struct piece {
    std::uint32_t chord;                   // or none
    std::uint32_t corner;                  // of an edge: its first corner in the poly below
    std::uint32_t link[2] = {none, none};  // what follows at the start and at the end: 2 piece + (0 at the start of that piece, 1 at its end)
  };

  const poly_cuts& cuts_;
  const crossed_surface& s_;
  std::vector<std::uint32_t> piece_at_;        // by corner, at edges on the level set
  std::vector<std::uint32_t> piece_of_chord_;  // or none
  std::vector<piece> pieces_;
  std::vector<unsigned char> is_joined_;

 public:
  explicit line_pieces(const poly_cuts& cuts);

  /// Joins the pieces: in the order of their first polys, with larger values to the left of the first piece.
  level_lines join();

 private:
  void make_pieces();
  void link_pieces();
  std::uint32_t follow(std::uint32_t piece, unsigned end) const;
  std::uint32_t follow_chord(std::uint32_t corner) const;
  std::uint32_t chord_end_at(std::uint32_t corner) const;
  std::uint32_t rotate(std::uint32_t corner, std::uint32_t vert) const;
  std::uint32_t edge_beside(std::uint32_t corner, std::uint32_t vert) const;

  void append(level_lines& lines, std::uint32_t piece, bool forward) const;
  void add_place(level_lines& lines, const level_place& x) const;
  void end_line(level_lines& lines, bool closed) const;
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/level_sets/detail/line_pieces.ipp>
#endif
