// The verts that remain after a repair, and their origins.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>
#include <concino/mesh/element_origins.hpp>
#include <concino/repair/detail/repair_log.hpp>

#include <cstdint>
#include <vector>

namespace concino::detail {

/// The new number of each vert; ~0u if it is removed: because it became another one, or because it is not in `used` and
/// is unreferenced.
std::vector<std::uint32_t> number_verts(const std::vector<vec3>& points, const std::vector<std::uint32_t>& vert_origin,
                                        const std::vector<std::uint32_t>& cluster,
                                        const std::vector<std::uint32_t>& used, bool remove_unreferenced,
                                        repair_log& log);

/// The origins of the verts that remain: all verts before of their clusters, or those that are listed for new verts.
element_origins origins_of_verts(const std::vector<std::uint32_t>& number,
                                 const std::vector<std::uint32_t>& vert_origin,
                                 const std::vector<std::uint32_t>& cluster,
                                 const std::vector<std::vector<std::uint32_t>>& of_new_verts);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/repair/detail/vert_origins.ipp>
#endif
