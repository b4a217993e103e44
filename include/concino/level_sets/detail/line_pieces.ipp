// The pieces of a level set on a surface, and lines of them; see line_pieces.hpp.
#pragma once

#include <concino/level_sets/detail/level_states.hpp>
#include <concino/level_sets/detail/line_pieces.hpp>

#include <algorithm>

namespace concino::detail {

CONCINO_INLINE line_pieces::line_pieces(const crossed_surface& s, double level) : s_(s), level_(level) {
  poly_of_.resize(num_corners());
  uses_.assign(2 * s_.num_polys.size(), none);
  for (std::uint32_t p = 0; p < s_.size(); ++p)
    for (std::uint32_t c = s_.first_corner[p]; c < s_.first_corner[p + 1]; ++c) {
      poly_of_[c] = p;
      std::uint32_t* const uses = uses_.data() + 2 * std::size_t{s_.edges[c]};
      (uses[0] == none ? uses[0] : uses[1]) = c;
    }
  find_chords();
  make_pieces();
  link_pieces();
}

/// The corner of the same edge in the only other poly at it; none if there is none, or if it is not crossed.
CONCINO_INLINE std::uint32_t line_pieces::other_use(std::uint32_t c) const {
  const std::uint32_t e = s_.edges[c];
  if (s_.num_polys[e] != 2) return none;
  return uses_[2 * std::size_t{e}] == c ? uses_[2 * std::size_t{e} + 1] : uses_[2 * std::size_t{e}];
}

CONCINO_INLINE void line_pieces::find_chords() {
  chord_at_.assign(num_corners(), none);
  state_.assign(num_corners(), is_below);
  polygon_crossings crossings;
  std::vector<unsigned char> above;
  std::vector<double> values;
  std::vector<vec3> points;
  for (std::uint32_t p = 0; p < s_.size(); ++p) {
    const std::uint32_t first = s_.first_corner[p], last = s_.first_corner[p + 1];
    above.clear(), values.clear(), points.clear();
    std::uint32_t start = 0;
    for (std::uint32_t c = first; c < last; ++c) {
      const std::uint32_t v = s_.verts[c];
      above.push_back(s_.states[v] != below_level);
      values.push_back(s_.values[v]);
      points.push_back(s_.points[v]);
      if (s_.vert_indices[v] < s_.vert_indices[s_.verts[first + start]]) start = c - first;
    }
    crossings.find(above, values, points, level_, start);
    const auto inner = static_cast<std::uint32_t>(inner_.size());
    for (const crossed_diagonal& d : crossings.inner()) inner_.push_back({first + d.below, first + d.above});
    for (const level_chord& c : crossings.chords()) {
      chord_at_[first + c.from] = chord_at_[first + c.to] = static_cast<std::uint32_t>(chords_.size());
      chords_.push_back({first + c.from, first + c.to, inner + c.inner_begin, inner + c.inner_end, none});
    }
    find_states(p);
  }
}

/// Follows the boundary of each part above: along the edges of the poly to a crossed one, and along its chord to the next corner.
CONCINO_INLINE void line_pieces::find_states(std::uint32_t poly) {
  std::vector<std::uint32_t> part;
  for (std::uint32_t c = s_.first_corner[poly]; c < s_.first_corner[poly + 1]; ++c) {
    if (s_.states[s_.verts[c]] == below_level || state_[c] != is_below) continue;
    part.clear();
    bool has_vert_above = false;
    for (std::uint32_t d = c; part.empty() || d != c;) {
      part.push_back(d);
      state_[d] = is_dropped;
      has_vert_above = has_vert_above || s_.states[s_.verts[d]] == above_level;
      d = chord_at_[d] == none ? next(d) : next(chords_[chord_at_[d]].to);
    }
    if (!has_vert_above) continue;
    for (const std::uint32_t d : part) state_[d] = is_above;
  }
}

CONCINO_INLINE void line_pieces::make_pieces() {
  piece_at_.assign(num_corners(), none);
  for (std::uint32_t c = 0; c < num_corners(); ++c) {
    if (const std::uint32_t chord = chord_at_[c]; chord != none) {
      if (chords_[chord].from != c || state_[c] != is_above) continue;
      chords_[chord].piece = static_cast<std::uint32_t>(pieces_.size());
      pieces_.push_back({chord, c});
    } else if (state_[c] == is_dropped && s_.num_polys[s_.edges[c]] == 2) {
      const std::uint32_t other = other_use(c);
      if (other != none && state_[other] != is_above) continue;
      piece_at_[c] = static_cast<std::uint32_t>(pieces_.size());
      pieces_.push_back({none, c});
    }
  }
}

/// Links are mutual; those that are not, of meshes that violate laws, are cut.
CONCINO_INLINE void line_pieces::link_pieces() {
  for (std::uint32_t i = 0; i < pieces_.size(); ++i)
    for (const unsigned end : {0u, 1u}) pieces_[i].link[end] = follow(i, end);
  for (std::uint32_t i = 0; i < pieces_.size(); ++i)
    for (const unsigned end : {0u, 1u})
      if (std::uint32_t& link = pieces_[i].link[end]; link != none && pieces_[link / 2].link[link % 2] != 2 * i + end) link = none;
}

/// What follows behind an end of a piece, as in piece::link.
CONCINO_INLINE std::uint32_t line_pieces::follow(std::uint32_t i, unsigned end) const {
  const piece& x = pieces_[i];
  if (x.chord != none) return follow_chord(end == 0 ? chords_[x.chord].from : chords_[x.chord].to);
  const std::uint32_t vert = s_.verts[end == 0 ? next(x.corner) : x.corner];  // the poly below is to the right of an edge
  return rotate(edge_beside(x.corner, vert), vert);
}

/// What follows a chord behind its end at a crossed edge.
CONCINO_INLINE std::uint32_t line_pieces::follow_chord(std::uint32_t corner) const {
  const std::uint32_t other = other_use(corner);
  if (other == none) return none;
  const chord& c = chords_[chord_at_[other]];
  if (c.piece != none) return 2 * c.piece + (c.from == other ? 0u : 1u);
  const std::uint32_t vert = s_.verts[s_.states[s_.verts[other]] == below_level ? next(other) : other];
  return rotate(edge_beside(other, vert), vert);
}

/// The other edge of the same poly at a vert of an edge, as its first corner.
CONCINO_INLINE std::uint32_t line_pieces::edge_beside(std::uint32_t corner, std::uint32_t vert) const {
  return s_.verts[corner] == vert ? previous(corner) : next(corner);
}

/// Turns around a vert on the level set, through dropped parts, to the next piece. `corner`: the edge by which to leave a poly.
CONCINO_INLINE std::uint32_t line_pieces::rotate(std::uint32_t corner, std::uint32_t vert) const {
  for (std::uint32_t steps = num_corners(); steps > 0; --steps) {
    const std::uint32_t other = other_use(corner);
    if (const std::uint32_t piece = piece_at_[corner]; piece != none) return 2 * piece + (s_.verts[corner] == vert ? 1u : 0u);
    if (other == none) return none;
    if (chord_at_[other] != none)
      if (const chord& c = chords_[chord_at_[other]]; c.piece != none) return 2 * c.piece + (c.from == other ? 0u : 1u);
    corner = edge_beside(other, vert);
  }
  return none;
}

CONCINO_INLINE level_lines line_pieces::join() {
  level_lines lines;
  is_joined_.assign(pieces_.size(), 0);
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
    if (is_joined_[i]) continue;
    std::uint32_t start = 2 * i;  // an end of a piece: the line starts there
    bool closed = false;
    for (std::uint32_t before = pieces_[i].link[0]; before != none; before = pieces_[start / 2].link[start % 2]) {
      start = before ^ 1u;
      closed = before / 2 == i;
      if (closed) break;
    }
    if (closed) start = 2 * i;
    for (std::uint32_t at = start;;) {
      append(lines, at / 2, at % 2 == 0);
      is_joined_[at / 2] = 1;
      const std::uint32_t after = pieces_[at / 2].link[at % 2 == 0 ? 1 : 0];
      if (after == none || after == start) break;
      at = after;
    }
    end_line(lines, closed);
  }
  return lines;
}

CONCINO_INLINE level_place line_pieces::place_between(level_place::kind_type kind, std::uint32_t element, std::uint32_t below, std::uint32_t above) const {
  if (s_.states[above] == on_level) return {level_place::vert, above, above, above};
  return {kind, element, below, above};
}
CONCINO_INLINE level_place line_pieces::place_on_edge(std::uint32_t corner) const {
  const std::uint32_t a = s_.verts[corner], b = s_.verts[next(corner)];
  return s_.states[a] == below_level ? place_between(level_place::edge, s_.edges[corner], a, b) : place_between(level_place::edge, s_.edges[corner], b, a);
}

/// Adds a place unless the line is there already; a line that returns at once to the place before loses both steps.
CONCINO_INLINE void line_pieces::add_place(level_lines& lines, const level_place& x) const {
  const std::size_t first = lines.ends.empty() ? 0 : lines.ends.back(), n = lines.places.size() - first;
  if (n > 0 && lines.places.back() == x) return;
  if (n > 1 && lines.places[lines.places.size() - 2] == x) lines.places.pop_back();
  else lines.places.push_back(x);
}

CONCINO_INLINE void line_pieces::append(level_lines& lines, std::uint32_t i, bool forward) const {
  const piece& x = pieces_[i];
  if (x.chord == none) {
    const std::uint32_t from = s_.verts[next(x.corner)], to = s_.verts[x.corner];
    for (const std::uint32_t v : {forward ? from : to, forward ? to : from}) add_place(lines, {level_place::vert, v, v, v});
    return;
  }
  const chord& c = chords_[x.chord];
  const std::uint32_t n = c.inner_end - c.inner_begin;
  add_place(lines, place_on_edge(forward ? c.from : c.to));
  for (std::uint32_t k = 0; k < n; ++k) {
    const crossed_diagonal& d = inner_[forward ? c.inner_begin + k : c.inner_end - 1 - k];
    add_place(lines, place_between(level_place::inside, poly_of_[c.from], s_.verts[d.below], s_.verts[d.above]));
  }
  add_place(lines, place_on_edge(forward ? c.to : c.from));
}

/// Ends the current line. One that has become a point or, if closed, a segment and back, has no size and is removed.
CONCINO_INLINE void line_pieces::end_line(level_lines& lines, bool closed) const {
  std::size_t first = lines.ends.empty() ? 0 : lines.ends.back(), last = lines.places.size();
  const auto& x = lines.places;
  if (closed) {
    if (last - first > 1 && x[first] == x[last - 1]) --last;
    while (last - first > 2 && x[first + 1] == x[last - 1]) ++first, --last;
  }
  if (last - first < (closed ? 3u : 2u)) {
    lines.places.resize(lines.ends.empty() ? 0 : lines.ends.back());
    return;
  }
  const std::size_t begin = lines.ends.empty() ? 0 : lines.ends.back();
  lines.places.resize(last);
  lines.places.erase(lines.places.begin() + static_cast<std::ptrdiff_t>(begin), lines.places.begin() + static_cast<std::ptrdiff_t>(first));
  lines.ends.push_back(lines.places.size());
  lines.closed.push_back(closed);
}

}  // namespace concino::detail
