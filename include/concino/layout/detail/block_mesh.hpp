// The mesh of blocks, where they are one.
#pragma once

#include <concino/layout/detail/blocks.hpp>

namespace concino::detail {

/// Finds the verts and cells of the mesh of blocks, or why there is none. The blocks are those of b.
void find_block_mesh(const cube_tables& t, block_tables& b);

}  // namespace concino::detail
