// Pieces of a part of a cell that only touch; see cell_parts.hpp.
#pragma once

#include <concino/level_sets/detail/cut/cell_parts.hpp>
#include <concino/level_sets/detail/cut/level_states.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Where what was between two pieces of a part had no size, they only touch, at a vert or an edge. Sorts one of them to
/// the front of the uses from `first` on, and returns where it ends. Edges with two faces connect.
CONCINO_INLINE std::size_t cell_parts::end_of_piece(std::vector<use>& uses, std::size_t first) {
  const auto is_on_level = [&](std::uint32_t place) {
    const level_place& x = numbers_.places[place];
    return x.kind == level_place::vert && v_.states[x.above] == on_level;
  };
  struct edge_use {
    std::uint32_t low, high, use;
  };
  std::vector<edge_use> edges;
  bool may_touch = false;
  for (std::size_t i = first; i < uses.size(); ++i) {
    const face& f = faces[uses[i].face];
    for (std::uint32_t k = f.first; k < f.last; ++k) may_touch = may_touch || is_on_level(face_places[k]);
  }
  if (!may_touch) return uses.size();
  for (std::size_t i = first; i < uses.size(); ++i) {
    const face& f = faces[uses[i].face];
    for (std::uint32_t k = f.first; k < f.last; ++k) {
      const std::uint32_t a = face_places[k], b = face_places[k + 1 < f.last ? k + 1 : f.first];
      edges.push_back({std::min(a, b), std::max(a, b), static_cast<std::uint32_t>(i - first)});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const edge_use& a, const edge_use& b) {
    return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.use < b.use;
  });
  disjoint_sets pieces(uses.size() - first);
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high) ++end;
    if (end == i + 2) pieces.unite(edges[i].use, edges[i + 1].use);
  }
  std::vector<use> here, others;
  for (std::size_t i = first; i < uses.size(); ++i)
    (pieces.root(i - first) == pieces.root(0) ? here : others).push_back(uses[i]);
  std::copy(here.begin(), here.end(), uses.begin() + static_cast<std::ptrdiff_t>(first));
  std::copy(others.begin(), others.end(), uses.begin() + static_cast<std::ptrdiff_t>(first + here.size()));
  return first + here.size();
}

}  // namespace concino::detail
