// Tutte's map of a disk, and the pieces of it that two verts separate from the boundary, from flat arrays.
#pragma once

#include <concino/parametrize/detail/flat_polys.hpp>
#include <concino/parametrize/uv_map.hpp>

#include <array>
#include <utility>
#include <vector>

namespace concino::detail {

struct flat_piece {
  std::array<std::uint32_t, 2> at;
  std::vector<std::uint32_t> verts;
};
struct disk_embedding {
  std::vector<uv_point> uv;
  std::vector<flat_piece> attached;
};

/// The boundary on the unit circle, in the order of the loop.      Errors: invalid_mesh if an edge has no length.
std::vector<uv_point> circle_of_loop(const flat_disk& f, const char* caller);

/// Sets the weight of the edge between two verts. Edges of no poly are left out.
/// Errors: invalid_argument if it is not positive and finite.
void set_edge_weight(const flat_disk& f, const std::array<std::uint32_t, 2>& ends, double weight,
                     std::vector<double>& by_edge);

/// weights: by edge of f; empty: equal ones. boundary: positions, or empty for the circle.
disk_embedding embed_disk(const flat_disk& f, const std::vector<std::pair<std::uint32_t, uv_point>>& boundary,
                          const std::vector<double>& weights);

/// The pieces without boundary verts that two verts separate from the others.
std::vector<flat_piece> attached_pieces(const flat_disk& f);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/parametrize/detail/attached_pieces.ipp>
#include <concino/parametrize/detail/disk_embedding.ipp>
#endif
