// Bodies of edge_lists.hpp: edges by their smaller vert, sorted there.
#pragma once

#include <concino/repair/detail/edge_lists.hpp>

#include <algorithm>

namespace concino::detail {

CONCINO_INLINE edge_lists::edge_lists(const std::vector<std::uint32_t>& poly_offsets,
                                      const std::vector<std::uint32_t>& verts, std::size_t num_verts)
    : edge_of_(verts.size()), poly_of_(verts.size()), next_(verts.size()) {
  struct half_edge {
    std::uint32_t to, corner;
  };
  std::vector<std::uint32_t> end(num_verts + 1);  // of the half-edges at each smaller vert
  for (std::size_t p = 0; p + 1 < poly_offsets.size(); ++p)
    for (std::uint32_t c = poly_offsets[p]; c < poly_offsets[p + 1]; ++c) {
      poly_of_[c] = static_cast<std::uint32_t>(p);
      next_[c] = c + 1 < poly_offsets[p + 1] ? c + 1 : poly_offsets[p];
      ++end[std::min(verts[c], verts[next_[c]]) + 1];
    }
  for (std::size_t v = 0; v < num_verts; ++v) end[v + 1] += end[v];
  std::vector<half_edge> all(verts.size());
  for (std::uint32_t c = 0; c < verts.size(); ++c) {
    const std::uint32_t a = verts[c], b = verts[next_[c]];
    all[end[std::min(a, b)]++] = {std::max(a, b), c};  // end[v] moves to where v ends
  }
  corners_.reserve(verts.size());
  first_.reserve(verts.size() / 2 + 1);
  for (std::size_t v = 0, from = 0; v < num_verts; ++v) {
    const std::size_t to = end[v];
    half_edge* const begin = all.data() + from;
    half_edge* const stop = all.data() + to;
    std::sort(begin, stop, [](const half_edge& x, const half_edge& y) {
      return x.to != y.to ? x.to < y.to : x.corner < y.corner;
    });
    for (const half_edge* i = begin; i != stop; ++i) {
      if (i != begin && i->to != (i - 1)->to) first_.push_back(static_cast<std::uint32_t>(corners_.size()));
      corners_.push_back(i->corner);
    }
    if (begin != stop) first_.push_back(static_cast<std::uint32_t>(corners_.size()));
    from = to;
  }
  for (std::uint32_t e = 0; e + 1 < first_.size(); ++e)
    for (std::uint32_t i = first_[e]; i < first_[e + 1]; ++i) edge_of_[corners_[i]] = e;
}

}  // namespace concino::detail
