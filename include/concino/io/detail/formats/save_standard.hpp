// Writes meshes in any of the library's formats. It depends only on the dimension of the mesh, so it is part of the
// compiled library.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/detail/formats/save_with.hpp>
#include <concino/io/formats.hpp>

#include <string>

namespace concino::detail {

/// The same as save_flat and flat_text, with standard_formats.
template<int Dimension>
void save_standard(flat_mesh_source mesh, const std::string& path, const save_options& options);
template<int Dimension>
std::string standard_text(flat_mesh_source mesh, const save_options& options);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/io/detail/formats/save_standard.ipp>
#endif
