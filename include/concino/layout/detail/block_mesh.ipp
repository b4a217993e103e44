// Bodies of block_mesh.hpp: the mesh of blocks, where they are one.
#pragma once

#include <concino/layout/detail/block_mesh.hpp>
#include <concino/layout/detail/verts_of_parts.hpp>

#include <algorithm>

namespace concino::detail {

/// The corners of blocks, and the first edge or facet of the mesh in each of their edges and faces.
class block_corners {
  const cube_tables& t_;
  const block_tables& b_;

  /// The place in the block of what lies at its ends along all axes but those of `free`; none if it does not.
  std::uint32_t place_in_block(std::size_t p, unsigned corner, unsigned free) const {
    const layout_block& block = b_.blocks[b_.block[p]];
    const grid_position& x = b_.positions[p * t_.num_corners() + corner];
    unsigned place = 0;
    for (unsigned i = 0; i < t_.dimension; ++i) {
      if (free >> i & 1) continue;
      if (x[i] != 0 && x[i] != block.size[i]) return cube_tables::none;
      if (x[i] != 0) place |= 1u << i;
    }
    return place;
  }
  /// The axes of the block along which corners a and b of p differ.
  unsigned axes_between(std::size_t p, unsigned a, unsigned b) const {
    unsigned axes = 0;
    for (unsigned i = 0; i < t_.dimension; ++i)
      if (b_.positions[p * t_.num_corners() + a][i] != b_.positions[p * t_.num_corners() + b][i]) axes |= 1u << i;
    return axes;
  }

 public:
  std::vector<std::uint32_t> verts;       // 2^dimension for each block, by place
  std::vector<std::uint32_t> first_edge;  // by block, then axes that are free and place: 64 for each
  std::vector<std::uint32_t> first_facet;

  block_corners(const cube_tables& t, const block_tables& b)
      : t_(t), b_(b), verts(b.blocks.size() << t.dimension, t.none), first_edge(b.blocks.size() * 64, t.none),
        first_facet(b.blocks.size() * 64, t.none) {
    const unsigned n = t.num_corners(), d = t.dimension;
    const auto note = [&](std::uint32_t& first, std::uint32_t x) { first = std::min(first, x); };
    for (std::size_t p = 0; p < t.num_polys(); ++p) {
      const std::size_t block = b.block[p];
      for (unsigned k = 0; k < n; ++k)
        if (const std::uint32_t at = place_in_block(p, k, 0); at != t.none)
          verts[(block << d) + at] = t.poly_verts[p * n + k];
      for (unsigned e = 0; e < t.num_poly_edges(); ++e) {
        const unsigned a = e >> (d - 1), rest = e & ((1u << (d - 1)) - 1), low = (1u << a) - 1;
        const unsigned k = (rest & low) | ((rest & ~low) << 1), free = axes_between(p, k, k | 1u << a);
        if (const std::uint32_t at = place_in_block(p, k, free); at != t.none)
          note(first_edge[block * 64 + free * 8 + at], t.poly_edges[p * t.num_poly_edges() + e]);
      }
      for (unsigned f = 0; d == 3 && f < 6; ++f) {
        const unsigned k = f & 1 ? 1u << (f / 2) : 0, free = axes_between(p, k, k ^ (7u ^ 1u << (f / 2)));
        if (const std::uint32_t at = place_in_block(p, k, free); at != t.none)
          note(first_facet[block * 64 + free * 8 + at], t.facet(p, f));
      }
    }
  }
};

inline std::string_view why_no_block_mesh(const cube_tables& t, const block_tables& b, const block_corners& c) {
  if (b.is_periodic) return "a block continues with its own polys, so it has no corners";
  const unsigned n = t.num_corners();
  verts_of_parts edges, facets, polys;  // by their first edge, facet or poly of the mesh
  for (std::uint32_t block = 0; block < b.blocks.size(); ++block) {
    const std::uint32_t* const verts = c.verts.data() + block * n;
    if (!polys.add(verts, n, block)) return "a block has one vert at two of its corners";
    for (unsigned free = 1; free < n; ++free)
      for (unsigned at = 0; at < n; ++at) {
        if (at & free) continue;
        std::uint32_t its_verts[4];
        std::size_t count = 0;
        for (unsigned k = 0; k < n; ++k)
          if ((k & ~free) == at && count < 4) its_verts[count++] = verts[k];
        const std::uint32_t edge = c.first_edge[block * 64 + free * 8 + at];
        const std::uint32_t facet = c.first_facet[block * 64 + free * 8 + at];
        if (edge != t.none) edges.add(its_verts, 2, edge);
        if (facet != t.none) facets.add(its_verts, 4, facet);
      }
  }
  if (edges.has_two_on_same_verts()) return "two edges of blocks have the same ends";
  if (facets.has_two_on_same_verts()) return "two faces of blocks have the same verts";
  if (polys.has_two_on_same_verts()) return "two blocks have the same verts";
  return {};
}

CONCINO_INLINE void find_block_mesh(const cube_tables& t, block_tables& b) {
  const block_corners c(t, b);
  b.why_no_mesh = why_no_block_mesh(t, b, c);
  if (!b.why_no_mesh.empty()) return;
  std::vector<std::uint32_t> number(t.num_verts, t.none);
  for (const std::uint32_t v : c.verts) number[v] = 0;
  for (std::uint32_t v = 0; v < t.num_verts; ++v)
    if (number[v] == 0) number[v] = static_cast<std::uint32_t>(b.verts.size()), b.verts.push_back(v);
  const unsigned n = t.num_corners();
  for (std::size_t block = 0; block < b.blocks.size(); ++block)
    for (unsigned k = 0; k < n; ++k) b.cells.push_back(number[c.verts[block * n + corner_places[k]]]);
}

}  // namespace concino::detail
