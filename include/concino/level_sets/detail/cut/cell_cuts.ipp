// How a level set cuts the cells of a volume; see cell_cuts.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/local_numbers.hpp>
#include <concino/level_sets/detail/cut/cell_cuts.hpp>
#include <concino/level_sets/detail/cut/level_states.hpp>

namespace concino::detail {

CONCINO_INLINE cell_cuts::cell_cuts(const crossed_volume& v, cells_are surface, const char* caller,
                                    const std::vector<std::uint32_t>& cell_indices)
    : v_(v) {
  number_facets();
  mates_.assign(v_.num_corners(), none);
  cell_vert_.assign(v_.num_corners(), none);
  seen_in_.assign(v_.points.size(), none);
  number_in_cell_.assign(v_.points.size(), none);
  for (std::uint32_t c = 0; c < v_.num_cells(); ++c)
    if (!find_mates(c, surface))
      core::throw_joined<unsupported>({caller, ": the faces of poly ", cell_indices[c],
                                       " do not form one closed surface without handles that are oriented outward, ",
                                       "so that it has no inside; validate(m) says more"});
  find_twins();
  find_chords();
  find_regions();
  find_loops();
}

CONCINO_INLINE void cell_cuts::number_facets() {
  cell_of_.assign(v_.num_facets(), none);
  facet_of_.assign(v_.num_corners(), none);
  for (std::uint32_t c = 0; c < v_.num_cells(); ++c)
    for (std::uint32_t s = v_.first_facet[c]; s < v_.first_facet[c + 1]; ++s) {
      cell_of_[s] = c;
      for (std::uint32_t k = v_.first_corner[s]; k < v_.first_corner[s + 1]; ++k) facet_of_[k] = s;
    }
}

/// Pairs the two uses of each edge by the facets of a cell, and numbers its verts. Returns false if its surface is not
/// a sphere.
CONCINO_INLINE bool cell_cuts::find_mates(std::uint32_t cell, cells_are surface) {
  surface_.clear();
  const std::uint32_t first = v_.first_corner[v_.first_facet[cell]];
  std::size_t num_verts = 0;
  for (std::uint32_t s = v_.first_facet[cell]; s < v_.first_facet[cell + 1]; ++s) {
    for (std::uint32_t k = v_.first_corner[s]; k < v_.first_corner[s + 1]; ++k) {
      const std::uint32_t v = v_.verts[k];
      surface_.add_corner(v);
      if (seen_in_[v] != cell) {
        seen_in_[v] = cell;
        number_in_cell_[v] = static_cast<std::uint32_t>(cell_vert_states_.size());
        cell_vert_states_.push_back(v_.states[v]);
        ++num_verts;
      }
      cell_vert_[k] = number_in_cell_[v];
    }
    surface_.end_facet(v_.outward[s]);
  }
  if (!surface_.find_mates() || (surface == cells_are::unknown && !surface_.is_sphere(num_verts))) return false;
  for (std::uint32_t k = 0; k < surface_.mates().size(); ++k) mates_[first + k] = first + surface_.mates()[k];
  return true;
}

CONCINO_INLINE void cell_cuts::find_twins() {
  twins_.assign(v_.num_facets(), none);
  core::local_numbers faces;
  std::vector<std::uint32_t> first;  // by face: the facet that has it first
  for (std::uint32_t s = 0; s < v_.num_facets(); ++s) {
    if (v_.num_polys[s] != 2) continue;
    const unsigned face = faces.add(v_.faces[s]);
    if (face == first.size()) first.push_back(s);
    else twins_[s] = first[face], twins_[first[face]] = s;
  }
}

CONCINO_INLINE void cell_cuts::find_chords() {
  chord_at_.assign(v_.num_corners(), none);
  first_chord_.reserve(v_.num_facets() + std::size_t{1}), chords_.reserve(v_.num_facets());
  for (std::uint32_t s = 0; s < v_.num_facets(); ++s) {
    first_chord_.push_back(static_cast<std::uint32_t>(chords_.size()));
    const std::uint32_t twin = twins_[s];
    if (twin >= s) {
      find_chords_of(s);
      continue;
    }
    // The other facet of the face has been crossed already: corner after corner the same.
    const std::uint32_t from = first_chord_[twin], to = first_chord_[twin + 1],
                        shift = v_.first_corner[s] - v_.first_corner[twin];
    for (std::uint32_t i = from; i < to; ++i) {
      chord c = chords_[i];
      c.facet = s;
      c.from += shift, c.to += shift;
      chord_at_[c.from] = chord_at_[c.to] = static_cast<std::uint32_t>(chords_.size());
      chords_.push_back(c);
    }
  }
  first_chord_.push_back(static_cast<std::uint32_t>(chords_.size()));
}

CONCINO_INLINE void cell_cuts::find_chords_of(std::uint32_t facet) {
  const std::uint32_t first = v_.first_corner[facet], last = v_.first_corner[facet + 1];
  unsigned char joint = 0;
  for (std::uint32_t k = first; k < last; ++k) joint |= v_.states[v_.verts[k]];
  if (!is_crossed(joint)) return;
  above_.clear(), values_.clear(), points_.clear();
  std::uint32_t start = 0;
  for (std::uint32_t k = first; k < last; ++k) {
    const std::uint32_t v = v_.verts[k];
    above_.push_back(v_.states[v] != below_level);
    values_.push_back(v_.values[v]);
    points_.push_back(v_.points[v]);
    if (v_.vert_indices[v] < v_.vert_indices[v_.verts[first + start]]) start = k - first;
  }
  crossings_.find(above_, values_, points_, v_.level(), start);
  const auto inner = static_cast<std::uint32_t>(inner_.size());
  for (const crossed_diagonal& d : crossings_.inner())
    inner_.push_back({v_.verts[first + d.below], v_.verts[first + d.above]});
  for (const level_chord& c : crossings_.chords()) {
    chord_at_[first + c.from] = chord_at_[first + c.to] = static_cast<std::uint32_t>(chords_.size());
    chords_.push_back({first + c.from, first + c.to, inner + c.inner_begin, inner + c.inner_end, facet});
  }
}

/// Unites the verts of each region: the ends of edges that are not crossed, and the verts on either side of a chord.
CONCINO_INLINE void cell_cuts::find_regions() {
  const std::vector<unsigned char>& states = cell_vert_states_;
  regions_ = disjoint_sets(states.size());
  for (std::uint32_t k = 0; k < v_.num_corners(); ++k)
    if (chord_at_[k] == none) regions_.unite(cell_vert_[k], cell_vert_[next(k)]);
  for (const chord& c : chords_) {
    regions_.unite(cell_vert_[c.from], cell_vert_[next(c.to)]);
    regions_.unite(cell_vert_[next(c.from)], cell_vert_[c.to]);
  }
  region_states_.assign(states.size(), is_below);
  for (std::uint32_t i = 0; i < states.size(); ++i)
    if (states[i] != below_level) {
      unsigned char& of_region = region_states_[regions_.root(i)];
      if (of_region != is_above) of_region = states[i] == above_level ? is_above : is_dropped;
    }
}

CONCINO_INLINE void cell_cuts::find_loops() {
  for (std::uint32_t i = 0; i < chords_.size(); ++i) {
    if (chords_[i].loop != none) continue;
    const auto number = static_cast<std::uint32_t>(loops_.size()),
               first = static_cast<std::uint32_t>(loop_chords_.size());
    const bool cuts = state(chords_[i].from) == is_above;
    for (std::uint32_t at = i; chords_[at].loop == none; at = chord_at_[mates_[end(chords_[at])]]) {
      chords_[at].loop = number;
      loop_chords_.push_back(at);
    }
    loops_.push_back({first, static_cast<std::uint32_t>(loop_chords_.size()), cell_of_[chords_[i].facet], cuts});
  }
}

/// A chord that crosses between two cells has the same number among those of both sides.
CONCINO_INLINE bool cell_cuts::is_active(std::uint32_t number) const {
  const std::uint32_t facet = chords_[number].facet, twin = twins_[facet];
  return loops_[chords_[number].loop].cuts ||
         (twin != none && loops_[chords_[number - first_chord_[facet] + first_chord_[twin]].loop].cuts);
}

}  // namespace concino::detail
