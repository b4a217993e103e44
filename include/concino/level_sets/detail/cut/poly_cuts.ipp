// How a level set cuts the polys of a surface; see poly_cuts.hpp.
#pragma once

#include <concino/level_sets/detail/cut/level_states.hpp>
#include <concino/level_sets/detail/cut/poly_cuts.hpp>

namespace concino::detail {

CONCINO_INLINE poly_cuts::poly_cuts(const crossed_surface& s, double level) : s_(s) {
  poly_of_.resize(num_corners());
  uses_.assign(2 * s_.num_polys.size(), none);
  for (std::uint32_t p = 0; p < s_.size(); ++p)
    for (std::uint32_t c = s_.first_corner[p]; c < s_.first_corner[p + 1]; ++c) {
      poly_of_[c] = p;
      std::uint32_t* const uses = uses_.data() + 2 * std::size_t{s_.edges[c]};
      (uses[0] == none ? uses[0] : uses[1]) = c;
    }
  find_chords(level);
}

CONCINO_INLINE std::uint32_t poly_cuts::other_use(std::uint32_t c) const {
  const std::uint32_t e = s_.edges[c];
  if (s_.num_polys[e] != 2) return none;
  return uses_[2 * std::size_t{e}] == c ? uses_[2 * std::size_t{e} + 1] : uses_[2 * std::size_t{e}];
}

CONCINO_INLINE void poly_cuts::find_chords(double level) {
  chord_at_.assign(num_corners(), none);
  state_.assign(num_corners(), is_below);
  chords_.reserve(s_.size());
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
    crossings.find(above, values, points, level, start);
    const auto inner = static_cast<std::uint32_t>(inner_.size());
    for (const crossed_diagonal& d : crossings.inner()) inner_.push_back({first + d.below, first + d.above});
    for (const level_chord& c : crossings.chords()) {
      chord_at_[first + c.from] = chord_at_[first + c.to] = static_cast<std::uint32_t>(chords_.size());
      chords_.push_back({first + c.from, first + c.to, inner + c.inner_begin, inner + c.inner_end, p, false});
    }
    find_states(p);
  }
}

/// Follows the boundary of each part above: along the edges of the poly to a crossed one, and along its chord to the
/// next corner.
CONCINO_INLINE void poly_cuts::find_states(std::uint32_t poly) {
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
    for (const std::uint32_t d : part) {
      state_[d] = is_above;
      if (chord_at_[d] != none) chords_[chord_at_[d]].cuts = true;
    }
  }
}

CONCINO_INLINE level_place poly_cuts::place_between(level_place::kind_type kind, std::uint32_t element,
                                                    std::uint32_t below, std::uint32_t above) const {
  if (s_.states[above] == on_level) return {level_place::vert, above, above, above};
  return {kind, element, below, above};
}
CONCINO_INLINE level_place poly_cuts::crossing(std::uint32_t corner) const {
  const std::uint32_t a = s_.verts[corner], b = s_.verts[next(corner)];
  return s_.states[a] == below_level ? place_between(level_place::edge, s_.edges[corner], a, b)
                                     : place_between(level_place::edge, s_.edges[corner], b, a);
}
CONCINO_INLINE level_place poly_cuts::crossing(const chord& c, std::uint32_t inner) const {
  return place_between(level_place::inside, c.poly, s_.verts[inner_[inner].below], s_.verts[inner_[inner].above]);
}

}  // namespace concino::detail
