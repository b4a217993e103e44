// Reads and writes PLY, the polygon file format of Stanford: surfaces with properties, as text or binary.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/detail/formats/load_with.hpp>
#include <concino/io/detail/formats/save_with.hpp>
#include <concino/io/detail/ply/ply_format.hpp>

#ifndef CONCINO_COMPILED
#include <concino/io/detail/ply/read_ply.hpp>
#include <concino/io/detail/ply/write_ply.hpp>
#endif

namespace concino {

/// Reads a mesh from a PLY file, whatever its extension; no other format is compiled.
/// Needs:  Loadable M, a surface.
/// Result: as load.
/// Cost:   as load.
/// Errors: as load, except that any extension is accepted.
template<Loadable M>
M load_ply(const std::string& path, const load_options& options = {}) {
  return detail::load_with<M>(path, file_format::ply, options);
}

/// Writes a mesh to a PLY file, whatever its extension; no other format is compiled.
/// Needs:  a surface mesh with points, of any type.
/// Result: as save.
/// Cost:   as save.
/// Errors: as save, except that any extension is accepted.
template<EmbeddedMesh M>
void save_ply(const M& m, const std::string& path, const save_options& options = {}) {
  detail::save_with(m, path, file_format::ply, options);
}

}  // namespace concino
