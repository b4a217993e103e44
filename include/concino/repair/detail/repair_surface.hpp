// Repairs a surface, as lists.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/mesh/arrays.hpp>
#include <concino/mesh/element_origins.hpp>
#include <concino/repair/detail/repair_log.hpp>
#include <concino/repair/repair_options.hpp>

#include <cstdint>
#include <vector>

namespace concino::detail {

/// Arrays that were repaired, and the numbers before of the verts and polys of which theirs were made.
template<class Arrays>
struct repaired_arrays {
  Arrays arrays;
  element_origins verts, polys;
  std::vector<std::uint32_t> cluster;  // by vert before: a number that verts which became one have in common
};

/// Polys of any size for arity 0.
repaired_arrays<surface_arrays> repair_surface(surface_arrays a, std::uint32_t arity, const repair_options& options,
                                               repair_log& log);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/repair/detail/repair_surface.ipp>
#endif
