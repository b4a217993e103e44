// Reads and writes TetGen's surfaces, .smesh and .poly.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/detail/formats/load_with.hpp>
#include <concino/io/detail/formats/save_with.hpp>
#include <concino/io/detail/tetgen/smesh_format.hpp>

#ifndef CONCINO_COMPILED
#include <concino/io/detail/tetgen/read_smesh.hpp>
#include <concino/io/detail/tetgen/write_smesh.hpp>
#endif

namespace concino {

/// Reads a mesh from a .smesh file, whatever its extension; no other format is compiled.
/// Needs:  Loadable M, a surface.
/// Result: as load.
/// Cost:   as load.
/// Errors: as load, except that any extension is accepted.
template<Loadable M>
M load_smesh(const std::string& path, const load_options& options = {}) {
  return detail::load_with<M>(path, file_format::smesh, options);
}

/// Writes a mesh to a .smesh file, whatever its extension; no other format is compiled.
/// Needs:  a surface mesh with points, of any type.
/// Result: as save.
/// Cost:   as save.
/// Errors: as save, except that any extension is accepted.
template<EmbeddedMesh M>
void save_smesh(const M& m, const std::string& path, const save_options& options = {}) {
  detail::save_with(m, path, file_format::smesh, options);
}

/// Reads a mesh from a .poly file, whatever its extension; no other format is compiled.
/// Needs:  Loadable M, a surface.
/// Result: as load.
/// Cost:   as load.
/// Errors: as load, except that any extension is accepted.
template<Loadable M>
M load_poly(const std::string& path, const load_options& options = {}) {
  return detail::load_with<M>(path, file_format::poly, options);
}

/// Writes a mesh to a .poly file, whatever its extension; no other format is compiled.
/// Needs:  a surface mesh with points, of any type.
/// Result: as save.
/// Cost:   as save.
/// Errors: as save, except that any extension is accepted.
template<EmbeddedMesh M>
void save_poly(const M& m, const std::string& path, const save_options& options = {}) {
  detail::save_with(m, path, file_format::poly, options);
}

}  // namespace concino
