// What load_options::repeated_verts does to the contents of a file, after any format was read.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/file_contents.hpp>

#include <cstddef>

namespace concino::detail {

/// Collapses or skips the polys of a surface that have a vert twice, drops the values of polys that have become none,
/// and gives each poly of the mesh the values of its poly in the file. Called once a file is read.
void mend_repeated_verts(file_contents& contents, std::size_t num_polys_of_volume, load_report& report);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/io/detail/formats/mend_repeated_verts.ipp>
#endif
