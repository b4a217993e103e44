// The values of named properties as numbers or texts.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/render/inspected_mesh.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace concino::detail {

/// Whether corners have properties.
bool has_corner_properties(const property_set& all);

/// Appends the values of properties of verts, edges, faces, polys, corners and the mesh whose types are numbers, arrays
/// of up to four or of nine numbers, vectors, bool or texts. Others are left out. corners: the number of each corner in
/// its property, by place in the lists of corners.
void add_properties(std::vector<inspected_values>& to, const property_set& all, std::span<const std::size_t> corners);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/render/detail/page/property_values.ipp>
#endif
