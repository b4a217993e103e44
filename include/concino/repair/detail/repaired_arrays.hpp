// The arrays of a mesh after its repair, made of the lists that were repaired.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/mesh/arrays.hpp>
#include <concino/mesh/element_origins.hpp>
#include <concino/repair/detail/repair_log.hpp>
#include <concino/repair/detail/surface_lists.hpp>

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

/// The lists of a surface with offsets, before its repair.
surface_lists lists_of(surface_arrays a);

/// The surface without verts that have become others, and if wished without those of no poly.
repaired_arrays<surface_arrays> arrays_of_lists(surface_lists s, std::uint32_t arity, bool remove_unreferenced,
                                                repair_log& log);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/repair/detail/repaired_arrays.ipp>
#endif
