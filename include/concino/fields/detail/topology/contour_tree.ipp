// Refusal of meshes with loops; see contour_tree.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/fields/contour_tree.hpp>

namespace concino::detail {

[[noreturn, gnu::noinline, gnu::cold]] CONCINO_INLINE void throw_has_loops(std::ptrdiff_t loops) {
  core::throw_joined<unsupported>({"contour_tree: the mesh has ", loops, loops == 1 ? " loop" : " loops",
                                   " that it does not fill; call reeb_graph"});
}

}  // namespace concino::detail
