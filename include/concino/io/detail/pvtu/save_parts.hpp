// Writes the parts of a mesh as the pieces of a .pvtu file.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/detail/formats/save_with.hpp>
#include <concino/io/detail/pvtu/pvtu_master.hpp>

#include <cstdint>
#include <span>
#include <string>

namespace concino::detail {

/// Errors: invalid_argument if the boundary is asked for.
void check_parts_are_wanted(const std::string& path, const save_options& options);

/// Writes a part.      Result: its arrays.
piece_arrays save_part(flat_mesh& part, text_sink& out, const std::string& name, const save_options& options);

/// Writes the polys of each part to a file of its own, and the .pvtu file that names them; see save_pvtu. The parts of
/// polys are in the order of the mesh.
void save_parts(flat_mesh_source mesh, std::span<const std::uint32_t> part_of_poly, const std::string& path,
                const save_options& options);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/io/detail/pvtu/save_parts.ipp>
#endif
