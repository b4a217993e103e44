// The blocks of quads or hexes: facets that continue from singular ridges, and what these leave connected.
#pragma once

#include <concino/layout/detail/cube_tables.hpp>

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace concino {

/// A block of coarse_layout: a grid of polys.
struct layout_block {
  std::array<std::uint32_t, 3> size = {0, 0, 1};  // polys along i, j and, in volumes, k
  std::array<bool, 3> periodic = {};  // whether the block has no end along i, j or k, but continues with its
                                      // own polys
  friend bool operator==(const layout_block&, const layout_block&) = default;
};

namespace detail {

using grid_position = std::array<std::uint32_t, 3>;

struct block_tables {
  std::vector<unsigned char> is_interface;  // by facet
  std::vector<std::uint32_t> block;         // by poly
  std::vector<grid_position> positions;     // by poly and place of the corner
  std::vector<layout_block> blocks;
  std::vector<std::uint32_t> verts;  // those of the mesh of blocks: verts of the mesh
  std::vector<std::uint32_t> cells;  // its polys: numbers in `verts`, in standard order
  std::string_view why_no_mesh;      // empty if these are the polys of a mesh
  bool is_periodic = false;
};

/// By facet, whether it is an interface: it has another number of polys than two, but some, or it continues from a
/// ridge that is not regular.
std::vector<unsigned char> find_interfaces(const cube_tables& t);

/// Groups of interior facets that continue each other from ridges that are not regular. Of a surface they are in the
/// order of a walk, and `ridges` has the verts of it.
struct separatrix_facets {
  std::vector<std::uint32_t> facets, ridges;
};
std::vector<separatrix_facets> find_separatrices(const cube_tables& t);

block_tables find_blocks(const cube_tables& t);

}  // namespace detail

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/layout/detail/block_mesh.ipp>
#include <concino/layout/detail/blocks.ipp>
#include <concino/layout/detail/separatrices.ipp>
#endif
