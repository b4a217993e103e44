// Dual verts that belong to no dual poly, and the descriptors in dual_maps.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>
#include <concino/generate/dual_mesh_options.hpp>

#include <cstdint>
#include <vector>

namespace concino::detail {

template<class Id>
std::vector<Id> ids(const std::vector<std::uint32_t>& numbers) {
  std::vector<Id> all;
  all.reserve(numbers.size());
  for (const std::uint32_t n : numbers) all.push_back(Id{n});
  return all;
}

/// Removes the dual verts that no loop uses, also from the maps.
void drop_unused_dual_verts(std::vector<vec3>& points, std::vector<vert_id>& loops, dual_maps* maps);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/generate/detail/dual/unused_dual_verts.ipp>
#endif
