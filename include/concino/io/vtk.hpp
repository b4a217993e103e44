// Reads and writes legacy VTK files, .vtk, as text or binary: any surface and any volume, with properties.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/detail/formats/load_with.hpp>
#include <concino/io/detail/formats/save_with.hpp>
#include <concino/io/detail/vtk/vtk_format.hpp>

#ifndef CONCINO_COMPILED
#include <concino/io/detail/vtk/read_vtk.hpp>
#include <concino/io/detail/vtk/write_vtk.hpp>
#endif

namespace concino {

/// Reads a mesh from a legacy VTK file, whatever its extension; no other format is compiled.
/// Needs:  Loadable M.
/// Result: as load.
/// Cost:   as load.
/// Errors: as load, except that any extension is accepted.
template<Loadable M>
M load_vtk(const std::string& path, const load_options& options = {}) {
  return detail::load_with<M>(path, file_format::vtk, options);
}

/// Writes a mesh to a legacy VTK file of version 3.0, whatever its extension; no other format is compiled.
/// Needs:  a mesh with points, of any type.
/// Result: as save.
/// Cost:   as save.
/// Errors: as save, except that any extension is accepted.
template<EmbeddedMesh M>
void save_vtk(const M& m, const std::string& path, const save_options& options = {}) {
  detail::save_with(m, path, file_format::vtk, options);
}

}  // namespace concino
