// Reads some verts of a binary mesh file without its polys: those of no poly, which no slice has.
#pragma once

#include <concino/io/load_slice.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace concino::core {

/// Reads the verts with these numbers.
/// Needs:  Loadable M; a file as for load_slice; numbers of its verts, which increase.
/// Result: a slice with these verts and their properties, and no polys.
/// Cost:   as load_slice for these verts.
/// Errors: as load_slice; invalid_argument if the file has fewer verts.
template<Loadable M>
mesh_slice<M> load_verts(const std::string& path, const std::vector<std::uint64_t>& verts,
                         const load_options& options = {}) {
  return detail::load_chosen_slice<M>(path, {0, 1, &verts}, options);
}

}  // namespace concino::core
