// The polygons of a level set in the cells of a volume; see level_polygons.hpp.
#pragma once

#include <concino/level_sets/detail/surfaces/level_polygons.hpp>

namespace concino::detail {

CONCINO_INLINE void level_polygons::number_segments() {
  std::uint32_t n = 0;
  for (std::uint32_t s = 0; s < v_.num_facets(); ++s) {
    const std::uint32_t first = cuts_.first_chord(s), last = cuts_.first_chord(s + 1), twin = cuts_.twin(s);
    for (std::uint32_t i = first; i < last; ++i) {
      const cell_cuts::chord& c = cuts_.chords()[i];
      if (twin < s) {
        first_segment_.push_back(first_segment_[cuts_.first_chord(twin) + (i - first)]);
      } else {
        first_segment_.push_back(n);
        n += c.inner_end - c.inner_begin + 1;
      }
    }
  }
  segment_user_.assign(n, none);
}

CONCINO_INLINE void level_polygons::use_segment(std::uint32_t segment, std::uint32_t corner) {
  if (segment_user_[segment] == none) segment_user_[segment] = corner;
  else sheets_.make_neighbours(segment_user_[segment], corner);
}

/// Adds the corners of a chord but for the last one, in the order from `from` to `to`, or backwards.
CONCINO_INLINE void level_polygons::add_chord(std::uint32_t chord, bool forward) {
  const cell_cuts::chord& c = cuts_.chords()[chord];
  const std::uint32_t n = c.inner_end - c.inner_begin, first = first_segment_[chord];
  for (std::uint32_t k = 0; k <= n; ++k) {
    const level_place x =
        k == 0 ? cuts_.crossing(forward ? c.from : c.to)
               : cuts_.crossing(c.facet, cuts_.inner()[forward ? c.inner_begin + k - 1 : c.inner_end - k]);
    use_segment(forward ? first + k : first + n - k, sheets_.add_corner(x));
  }
}

CONCINO_INLINE void level_polygons::add_cap(const cell_cuts::loop& loop) {
  for (std::uint32_t i = loop.first; i < loop.last; ++i) {
    const std::uint32_t chord = cuts_.loop_chords()[i];
    add_chord(chord, v_.outward[cuts_.chords()[chord].facet] != 0);
  }
  sheets_.end_polygon(loop.cell);
}

/// Finds the parts of facets that are dropped in their own cell, and above in the cell across.
CONCINO_INLINE void level_polygons::find_facets() {
  has_facet_.assign(v_.num_corners(), 0);
  edge_user_.assign(v_.num_corners(), none);
  for (std::uint32_t k = 0; k < v_.num_corners(); ++k) {
    if (cuts_.state(k) != cell_cuts::is_dropped) continue;
    const std::uint32_t facet = cuts_.facet_of(k), twin = cuts_.twin(facet);
    if (v_.num_polys[facet] != 2) continue;
    has_facet_[k] =
        twin == none || cuts_.state(k - v_.first_corner[facet] + v_.first_corner[twin]) == cell_cuts::is_above;
  }
}

/// Adds the part of a facet at a corner on the level set: counter-clockwise seen from outside the cell of the facet,
/// which is below.
CONCINO_INLINE void level_polygons::add_facet(std::uint32_t corner, std::vector<unsigned char>& is_done) {
  const bool forward = v_.outward[cuts_.facet_of(corner)] != 0;
  for (std::uint32_t k = corner; !is_done[k];) {
    is_done[k] = 1;
    const std::uint32_t edge = forward ? k : cuts_.previous(k), chord = cuts_.chord_at(edge);
    const std::uint32_t v = v_.verts[k];
    const std::uint32_t here = sheets_.add_corner({level_place::vert, v, v, v});
    if (chord == none) {
      edge_user_[edge] = here;
      k = forward ? cuts_.next(k) : cuts_.previous(k);
      continue;
    }
    // Larger values are to the left of a chord, so the boundary of a part above follows it.
    const cell_cuts::chord& c = cuts_.chords()[chord];
    add_chord(chord, c.from == edge);
    const std::uint32_t other = c.from == edge ? c.to : c.from;
    const std::uint32_t last = v_.verts[forward ? cuts_.next(other) : other];
    sheets_.add_corner({level_place::vert, last, last, last});
    k = forward ? cuts_.next(other) : other;
  }
  sheets_.end_polygon(cuts_.cell_of(cuts_.facet_of(corner)));
}

/// Finds the neighbour of each facet at each edge on the level set: it bounds the same parts below, through which the
/// search turns around the edge.
CONCINO_INLINE void level_polygons::link_edges() {
  for (std::uint32_t k = 0; k < v_.num_corners(); ++k) {
    if (edge_user_[k] == none) continue;
    std::uint32_t at = cuts_.mate(k);
    for (std::uint32_t steps = v_.num_corners(); steps > 0 && edge_user_[at] == none; --steps) {
      const std::uint32_t facet = cuts_.facet_of(at), twin = cuts_.twin(facet);
      if (v_.num_polys[facet] != 2 || twin == none) break;
      at = cuts_.mate(at - v_.first_corner[facet] + v_.first_corner[twin]);
    }
    if (edge_user_[at] != none) sheets_.make_neighbours(edge_user_[k], edge_user_[at]);
  }
}

CONCINO_INLINE void level_polygons::add_all() {
  number_segments();
  find_facets();
  std::vector<unsigned char> is_done(v_.num_corners(), 0);
  std::uint32_t loop = 0;
  for (std::uint32_t c = 0; c < v_.num_cells(); ++c) {
    for (; loop < cuts_.loops().size() && cuts_.loops()[loop].cell == c; ++loop)
      if (cuts_.loops()[loop].cuts) add_cap(cuts_.loops()[loop]);
    for (std::uint32_t k = v_.first_corner[v_.first_facet[c]]; k < v_.first_corner[v_.first_facet[c + 1]]; ++k)
      if (has_facet_[k] && !is_done[k]) add_facet(k, is_done);
  }
  link_edges();
}

}  // namespace concino::detail
