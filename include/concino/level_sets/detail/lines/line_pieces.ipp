// The pieces of a level set on a surface, and lines of them; see line_pieces.hpp.
#pragma once

#include <concino/level_sets/detail/cut/level_states.hpp>
#include <concino/level_sets/detail/lines/line_pieces.hpp>

#include <algorithm>

namespace concino::detail {

CONCINO_INLINE line_pieces::line_pieces(const poly_cuts& cuts) : cuts_(cuts), s_(cuts.surface()) {
  make_pieces(find_curves());
  link_pieces();
}

CONCINO_INLINE level_place line_pieces::place(std::uint32_t curve, std::uint32_t k) const {
  if (is_chord(curve)) return chord_places(cuts_, cuts_.chords()[curve])[k];
  // the poly below is to the right of an edge
  const std::uint32_t corner = curve - curve_of_edge(0), v = s_.verts[k == 0 ? cuts_.next(corner) : corner];
  return {level_place::vert, v, v, v};
}

/// The curves, by the corners of their polys.
CONCINO_INLINE std::vector<std::uint32_t> line_pieces::find_curves() const {
  std::vector<std::uint32_t> curves;
  for (std::uint32_t c = 0; c < cuts_.num_corners(); ++c) {
    if (const std::uint32_t chord = cuts_.chord_at(c); chord != none) {
      if (cuts_.chords()[chord].from == c && cuts_.chords()[chord].cuts) curves.push_back(chord);
    } else if (cuts_.state(c) == poly_cuts::is_dropped && s_.num_polys[s_.edges[c]] == 2) {
      const std::uint32_t other = cuts_.other_use(c);
      if (other == none || cuts_.state(other) == poly_cuts::is_above) curves.push_back(curve_of_edge(c));
    }
  }
  return curves;
}

CONCINO_INLINE void line_pieces::make_pieces(const std::vector<std::uint32_t>& curves) {
  std::vector<vert_step> steps;
  for (const std::uint32_t curve : curves)
    for (std::uint32_t k = 0, n = num_places(curve); k + 1 < n; ++k) {
      const level_place a = place(curve, k), b = place(curve, k + 1);
      if (a.kind == level_place::vert && b.kind == level_place::vert && a != b)
        steps.push_back({a.element, b.element, curve, k});
    }
  cancelled_ = find_cancelling_steps(steps);
  piece_before_.resize(cancelled_.size());
  pieces_.reserve(curves.size() + cancelled_.size());
  of_chords_.assign(cuts_.chords().size(), {});
  if (std::any_of(curves.begin(), curves.end(), [this](std::uint32_t c) { return !is_chord(c); }))
    of_edges_.assign(cuts_.num_corners(), {});
  for (const std::uint32_t curve : curves) {
    const auto is_before = [&](const cancelling_step& x) { return x.curve < curve; };
    auto at = static_cast<std::uint32_t>(std::partition_point(cancelled_.begin(), cancelled_.end(), is_before) -
                                         cancelled_.begin());
    piece x{curve};
    piece_range& of_curve = is_chord(curve) ? of_chords_[curve] : of_edges_[curve - curve_of_edge(0)];
    of_curve.first = static_cast<std::uint32_t>(pieces_.size());
    for (; at < cancelled_.size() && cancelled_[at].curve == curve; ++at) {
      x.last = cancelled_[at].step;
      x.cancelled[1] = at;
      piece_before_[at] = static_cast<std::uint32_t>(pieces_.size());
      pieces_.push_back(x);
      x.first = cancelled_[at].step + 1;
      x.cancelled[0] = at;
      x.cancelled[1] = none;
    }
    x.last = num_places(curve) - 1;
    of_curve.last = static_cast<std::uint32_t>(pieces_.size());
    pieces_.push_back(x);
  }
}

/// Links are mutual; those that are not, of meshes that violate laws, are cut.
CONCINO_INLINE void line_pieces::link_pieces() {
  for (std::uint32_t i = 0; i < pieces_.size(); ++i)
    for (const unsigned end : {0u, 1u}) pieces_[i].link[end] = follow(i, end);
  for (std::uint32_t i = 0; i < pieces_.size(); ++i)
    for (const unsigned end : {0u, 1u})
      if (std::uint32_t& link = pieces_[i].link[end]; link != none && pieces_[link / 2].link[link % 2] != 2 * i + end)
        link = none;
}

/// What follows behind an end of a piece, as in piece::link.
CONCINO_INLINE std::uint32_t line_pieces::follow(std::uint32_t i, unsigned end) const {
  const piece& x = pieces_[i];
  if (x.cancelled[end] != none) return 2 * piece_before_[cancelled_[x.cancelled[end]].other] + (end == 0 ? 1u : 2u);
  if (is_chord(x.curve)) return follow_chord(end == 0 ? cuts_.chords()[x.curve].from : cuts_.chords()[x.curve].to);
  return rotate(edge_beside(x.curve - curve_of_edge(0), place(x.curve, end).element), place(x.curve, end).element);
}

/// The end, as in piece::link, of the chord at a crossed edge; none if there is none that cuts.
CONCINO_INLINE std::uint32_t line_pieces::chord_end_at(std::uint32_t corner) const {
  const std::uint32_t chord = cuts_.chord_at(corner);
  if (chord == none || of_chords_[chord].first == none) return none;
  return cuts_.chords()[chord].from == corner ? 2 * of_chords_[chord].first : 2 * of_chords_[chord].last + 1;
}

/// What follows a chord behind its end at a crossed edge.
CONCINO_INLINE std::uint32_t line_pieces::follow_chord(std::uint32_t corner) const {
  const std::uint32_t other = cuts_.other_use(corner);
  if (other == none) return none;
  if (const std::uint32_t end = chord_end_at(other); end != none) return end;
  const std::uint32_t vert = s_.verts[s_.states[s_.verts[other]] == below_level ? cuts_.next(other) : other];
  return rotate(edge_beside(other, vert), vert);
}

/// The other edge of the same poly at a vert of an edge, as its first corner.
CONCINO_INLINE std::uint32_t line_pieces::edge_beside(std::uint32_t corner, std::uint32_t vert) const {
  return s_.verts[corner] == vert ? cuts_.previous(corner) : cuts_.next(corner);
}

/// Turns around a vert on the level set, through dropped parts, to the next piece. `corner`: the edge by which to leave
/// a poly.
CONCINO_INLINE std::uint32_t line_pieces::rotate(std::uint32_t corner, std::uint32_t vert) const {
  for (std::uint32_t steps = cuts_.num_corners(); steps > 0; --steps) {
    const std::uint32_t other = cuts_.other_use(corner);
    if (const piece_range x = pieces_of_edge(corner); x.first != none)
      return s_.verts[corner] == vert ? 2 * x.last + 1 : 2 * x.first;
    if (other == none) return none;
    if (const std::uint32_t end = chord_end_at(other); end != none) return end;
    corner = edge_beside(other, vert);
  }
  return none;
}

CONCINO_INLINE void line_pieces::append(level_lines& lines, std::uint32_t i, bool forward) const {
  const piece& x = pieces_[i];
  for (std::uint32_t k = x.first; k <= x.last; ++k) lines.add_place(place(x.curve, forward ? k : x.first + x.last - k));
}

CONCINO_INLINE level_lines line_pieces::join() const {
  const auto link_of = [this](std::uint32_t end) { return pieces_[end / 2].link[end % 2]; };
  level_lines lines;
  std::vector<unsigned char> is_joined(pieces_.size(), 0);
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
    if (is_joined[i]) continue;
    std::uint32_t start = 2 * i;  // an end of a piece: the line starts there
    bool closed = false;
    for (std::uint32_t before = link_of(start); before != none; before = link_of(start)) {
      start = before ^ 1u;
      closed = before / 2 == i;
      if (closed) break;
    }
    if (closed) start = 2 * i;
    for (std::uint32_t at = start;;) {
      append(lines, at / 2, at % 2 == 0);
      is_joined[at / 2] = 1;
      const std::uint32_t after = link_of(at ^ 1u);
      if (after == none || after == start) break;
      at = after;
    }
    lines.end_line(closed);
  }
  return lines;
}

}  // namespace concino::detail
