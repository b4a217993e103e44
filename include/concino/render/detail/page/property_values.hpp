// The values of named properties as numbers or texts.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/render/inspected_mesh.hpp>

#include <vector>

namespace concino::detail {

/// Appends the values of properties of verts, edges, faces, polys and the mesh whose types are numbers, arrays of up to
/// four or of nine numbers, vectors, bool or texts. Others are left out.
void add_properties(std::vector<inspected_values>& to, const property_set& all);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/render/detail/page/property_values.ipp>
#endif
