// The level set of a function on a surface: pieces in the polys that it crosses, and how they are joined to lines.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/level_sets/detail/cut/chord_places.hpp>
#include <concino/level_sets/detail/cut/level_place.hpp>
#include <concino/level_sets/detail/cut/poly_cuts.hpp>
#include <concino/level_sets/detail/lines/cancelling_steps.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Lines, one after another. Line i has the places from ends[i - 1] to ends[i].
struct level_lines {
  std::vector<level_place> places;
  std::vector<std::size_t> ends;
  std::vector<unsigned char> closed;

  /// Adds a place to the current line unless it is there already; a line that returns at once to the place before loses
  /// both steps.
  void add_place(const level_place& x) {
    const std::size_t n = places.size() - begin_of_current();
    if (n > 0 && places.back() == x) return;
    if (n > 1 && places[places.size() - 2] == x) places.pop_back();
    else places.push_back(x);
  }

  /// Ends the current line. One that has become a point or, if closed, a segment and back, has no size and is removed.
  void end_line(bool is_closed) {
    const std::size_t begin = begin_of_current();
    std::size_t first = begin, last = places.size();
    if (is_closed) {
      if (last - first > 1 && places[first] == places[last - 1]) --last;
      while (last - first > 2 && places[first + 1] == places[last - 1]) ++first, --last;
    }
    if (last - first < (is_closed ? 3u : 2u)) {
      places.resize(begin);
      return;
    }
    places.resize(last);
    places.erase(places.begin() + static_cast<std::ptrdiff_t>(begin),
                 places.begin() + static_cast<std::ptrdiff_t>(first));
    ends.push_back(places.size());
    closed.push_back(is_closed);
  }

 private:
  std::size_t begin_of_current() const { return ends.empty() ? 0 : ends.back(); }
};

/// The level set consists of curves: the chords that cut polys, and edges on the level set between a part below and a
/// part above. Steps of curves that are taken in both directions have nothing above between them and cancel; what is
/// left of a curve are its pieces.
class line_pieces {
  static constexpr std::uint32_t none = ~0u;

  struct piece {
    std::uint32_t curve;                        // a chord, or the number of chords plus the first corner of an edge in
                                                // the poly below
    std::uint32_t first = 0, last = 0;          // its places, from the first to the last one
    std::uint32_t cancelled[2] = {none, none};  // the steps before its first and behind its last place, in cancelled_
    std::uint32_t link[2] = {none, none};       // what follows at the start and at the end: 2 piece + (0 at the start
                                                // of that piece, 1 at its end)
  };
  struct piece_range {
    std::uint32_t first = none, last = none;
  };

  const poly_cuts& cuts_;
  const crossed_surface& s_;
  std::vector<piece> pieces_;
  std::vector<piece_range> of_chords_;
  std::vector<piece_range> of_edges_;        // by corner; empty if no edge is a curve
  std::vector<cancelling_step> cancelled_;
  std::vector<std::uint32_t> piece_before_;  // by step of cancelled_: the piece that ends there; the next one begins
                                             // behind it

 public:
  explicit line_pieces(const poly_cuts& cuts);

  /// Joins the pieces: in the order of their first polys, with larger values to the left of the first piece.
  level_lines join() const;

 private:
  bool is_chord(std::uint32_t curve) const { return curve < cuts_.chords().size(); }
  std::uint32_t curve_of_edge(std::uint32_t corner) const {
    return static_cast<std::uint32_t>(cuts_.chords().size()) + corner;
  }
  piece_range pieces_of_edge(std::uint32_t corner) const {
    return of_edges_.empty() ? piece_range{} : of_edges_[corner];
  }
  std::uint32_t num_places(std::uint32_t curve) const {
    return is_chord(curve) ? chord_places(cuts_, cuts_.chords()[curve]).size() : 2;
  }
  level_place place(std::uint32_t curve, std::uint32_t k) const;

  std::vector<std::uint32_t> find_curves() const;
  void make_pieces(const std::vector<std::uint32_t>& curves);
  void link_pieces();
  std::uint32_t follow(std::uint32_t piece, unsigned end) const;
  std::uint32_t follow_chord(std::uint32_t corner) const;
  std::uint32_t chord_end_at(std::uint32_t corner) const;
  std::uint32_t rotate(std::uint32_t corner, std::uint32_t vert) const;
  std::uint32_t edge_beside(std::uint32_t corner, std::uint32_t vert) const;

  void append(level_lines& lines, std::uint32_t piece, bool forward) const;
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/level_sets/detail/lines/line_pieces.ipp>
#endif
