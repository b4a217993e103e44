// The caps of hexes; see hex_caps.hpp.
#pragma once

#include <concino/level_sets/detail/hex_caps.hpp>
#include <concino/mesh/standard_cells.hpp>

namespace concino::detail {

/// A chord across a face, by the edges of the hex at its ends.
struct hex_chord {
  hex_cap_list::edge from, to;
};

constexpr bool is_same(hex_cap_list::edge a, hex_cap_list::edge b) { return a.below == b.below && a.above == b.above; }

/// Lists the chords of the faces. Returns how many there are, or 7 if a face has more than one.
constexpr unsigned find_hex_chords(unsigned signs, hex_chord (&chords)[6]) {
  const standard_cell& hex = standard_cell_of(cell_shape::hex);
  unsigned n = 0;
  for (const auto& face : hex.face_vert) {
    unsigned crossings = 0;
    hex_chord c{};
    for (unsigned k = 0; k < 4; ++k) {
      const auto a = static_cast<std::uint8_t>(face[k]), b = static_cast<std::uint8_t>(face[(k + 1) % 4]);
      const bool above = signs >> a & 1u, next_above = signs >> b & 1u;
      if (above == next_above) continue;
      ++crossings;
      if (next_above) c.to = {a, b};
      else c.from = {b, a};
    }
    if (crossings > 2) return 7;
    if (crossings == 2) chords[n++] = c;
  }
  return n;
}

/// Joins the chords to cycles, in the order in which the chords of other cells are joined.
constexpr hex_cap_list make_hex_caps(unsigned signs) {
  hex_cap_list caps;
  hex_chord chords[6] = {};
  unsigned left = find_hex_chords(signs, chords);
  if (left > 6) return caps;
  caps.is_simple = true;
  std::uint8_t corners = 0;
  while (left > 0) {
    const hex_cap_list::edge start = chords[left - 1].from;
    hex_cap_list::edge at = chords[--left].to;
    caps.corners[corners++] = start;
    while (!is_same(at, start)) {
      unsigned k = 0;
      while (!is_same(chords[k].from, at)) ++k;
      caps.corners[corners++] = at;
      at = chords[k].to;
      chords[k] = chords[--left];
    }
    caps.ends[caps.num_caps++] = corners;
  }
  return caps;
}

struct hex_cap_table {
  hex_cap_list lists[256];
  constexpr hex_cap_table() : lists{} {
    for (unsigned signs = 0; signs < 256; ++signs) lists[signs] = make_hex_caps(signs);
  }
};

CONCINO_INLINE const hex_cap_list& hex_caps(unsigned signs) {
  static constexpr hex_cap_table table{};
  return table.lists[signs];
}

}  // namespace concino::detail
