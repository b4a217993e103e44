// Writing in any of the formats of the library. It knows of the mesh no more than its dimension, so the compiled library has it.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/detail/save_with.hpp>
#include <concino/io/formats.hpp>

#include <string>

namespace concino::detail {

/// As save_flat and flat_text, with standard_formats.
template<int Dimension>
void save_standard(flat_mesh_source mesh, const std::string& path, const save_options& options);
template<int Dimension>
std::string standard_text(flat_mesh_source mesh, const save_options& options);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/io/detail/save_standard.ipp>
#endif
