// A chord of a polygon as a list of places: those of its two edges and of the diagonals between.
#pragma once

#include <concino/level_sets/detail/cut/poly_cuts.hpp>

#include <cstdint>

namespace concino::detail {

class chord_places {
  const poly_cuts& cuts_;
  const poly_cuts::chord& chord_;

 public:
  chord_places(const poly_cuts& cuts, const poly_cuts::chord& c) : cuts_(cuts), chord_(c) {}
  std::uint32_t size() const { return chord_.inner_end - chord_.inner_begin + 2; }
  level_place operator[](std::uint32_t k) const {
    if (k == 0) return cuts_.crossing(chord_.from);
    if (k + 1 == size()) return cuts_.crossing(chord_.to);
    return cuts_.crossing(chord_, chord_.inner_begin + k - 1);
  }
};

}  // namespace concino::detail
