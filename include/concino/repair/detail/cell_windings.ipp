// Bodies of cell_windings.hpp: a flood fill through faces of exactly two cells.
#pragma once

#include <concino/repair/detail/cell_windings.hpp>

namespace concino::detail {

CONCINO_INLINE std::vector<std::uint8_t> cells_to_turn(const cell_faces& cells, const std::vector<std::int8_t>& sign,
                                                       const std::vector<std::uint32_t>& origin, repair_log& log) {
  constexpr std::uint32_t none = ~0u;
  struct users {
    std::uint32_t cell[2] = {none, none};  // positions in cells.faces follow from them
    std::uint8_t outward[2] = {0, 0};
    std::uint32_t count = 0;
  };
  std::vector<users> of_face(cells.num_faces);
  for (std::uint32_t c = 0; c < cells.num_cells(); ++c)
    for (std::uint32_t i = cells.offsets[c]; i < cells.offsets[c + 1]; ++i) {
      users& u = of_face[cells.faces[i]];
      if (u.count < 2) u.cell[u.count] = c, u.outward[u.count] = cells.outward[i];
      ++u.count;
    }
  std::vector<std::uint8_t> turns(cells.num_cells()), is_known(cells.num_cells());
  std::vector<std::uint32_t> component;
  for (std::uint32_t start = 0; start < cells.num_cells(); ++start) {
    if (is_known[start]) continue;
    is_known[start] = 1;
    component.assign(1, start);
    bool is_one_sided = false;
    for (std::size_t k = 0; k < component.size(); ++k) {
      const std::uint32_t c = component[k];
      for (std::uint32_t i = cells.offsets[c]; i < cells.offsets[c + 1]; ++i) {
        const users& u = of_face[cells.faces[i]];
        if (u.count != 2 || u.cell[0] == u.cell[1]) continue;
        const std::uint32_t d = u.cell[0] == c ? u.cell[1] : u.cell[0];
        const auto wanted = static_cast<std::uint8_t>(turns[c] ^ (u.outward[0] == u.outward[1]));
        if (!is_known[d]) {
          is_known[d] = 1;
          turns[d] = wanted;
          component.push_back(d);
        } else {
          is_one_sided = is_one_sided || turns[d] != wanted;
        }
      }
    }
    std::size_t negative[2] = {0, 0}, turned[2] = {0, 0};  // without and with turning all once more
    for (const std::uint32_t c : component) {
      negative[0] += sign[c] * (turns[c] ? -1 : 1) < 0;
      negative[1] += sign[c] * (turns[c] ? -1 : 1) > 0;
      ++turned[turns[c] ? 0 : 1];
    }
    const bool again = negative[0] != negative[1] ? negative[1] < negative[0] : turned[1] < turned[0];
    if (is_one_sided) log.add(repair_kind::one_sided, origin[component[0]]);
    for (const std::uint32_t c : component) {
      turns[c] = is_one_sided ? std::uint8_t{0} : static_cast<std::uint8_t>(turns[c] ^ again);
      if (turns[c]) log.add(repair_kind::turned_polys, origin[c]);
      if (sign[c] * (turns[c] ? -1 : 1) < 0) log.add(repair_kind::inverted_cell, origin[c]);
    }
  }
  return turns;
}

}  // namespace concino::detail
