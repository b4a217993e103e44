// The caps of hexes, by the signs of their eight verts.
#pragma once

#include <concino/core/compiled.hpp>

#include <cstdint>

namespace concino::detail {

/// Caps as cycles of crossed edges, counter-clockwise seen from above. An edge is known by its verts in the standard order of a hex.
struct hex_cap_list {
  struct edge {
    std::uint8_t below, above;
  };
  bool is_simple = false;     // no face has more than one chord; otherwise there are no caps here
  std::uint8_t num_caps = 0;
  std::uint8_t ends[4] = {};  // by cap: where its corners end
  edge corners[12] = {};
};

/// Bit k of `signs` says whether vert k is above.
const hex_cap_list& hex_caps(unsigned signs);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/level_sets/detail/hex_caps.ipp>
#endif
