// The caps of tets, by the signs of their four verts.
#pragma once

#include <cstdint>

namespace concino::detail {

/// A cap as a cycle of crossed edges, counter-clockwise seen from above. Edges 0 to 5 join the verts 01 02 03 12 13 23.
struct tet_cap {
  std::uint8_t size = 0;
  std::uint8_t edges[4] = {};
};

/// Joins the chords of the four faces. Bit k of `signs` says whether vert k is above.
constexpr tet_cap make_tet_cap(unsigned signs) {
  constexpr std::uint8_t faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};  // counter-clockwise seen from outside
  constexpr std::uint8_t edge[4][4] = {{0, 0, 1, 2}, {0, 0, 3, 4}, {1, 3, 0, 5}, {2, 4, 5, 0}};
  std::uint8_t next[6] = {}, first = 6;
  for (const auto& face : faces) {
    std::uint8_t from = 6, to = 6;
    for (unsigned k = 0; k < 3; ++k) {
      const unsigned a = face[k], b = face[(k + 1) % 3];
      const bool above = signs >> a & 1u, above_next = signs >> b & 1u;
      if (above && !above_next) from = edge[a][b];
      if (!above && above_next) to = edge[a][b];
    }
    if (from == 6) continue;
    next[from] = to;
    if (first == 6) first = from;
  }
  tet_cap cap;
  if (first == 6) return cap;
  for (std::uint8_t e = first; cap.size == 0 || e != first; e = next[e]) cap.edges[cap.size++] = e;
  return cap;
}

struct tet_cap_table {
  tet_cap caps[16];
  constexpr tet_cap_table() : caps{} {
    for (unsigned signs = 0; signs < 16; ++signs) caps[signs] = make_tet_cap(signs);
  }
  constexpr const tet_cap& operator[](unsigned signs) const { return caps[signs]; }
};
inline constexpr tet_cap_table tet_caps{};

}  // namespace concino::detail
