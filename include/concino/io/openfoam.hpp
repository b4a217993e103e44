// Reads and writes the polyMesh folders of OpenFOAM, for volumes of any polyhedra.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/detail/formats/load_with.hpp>
#include <concino/io/detail/formats/save_with.hpp>
#include <concino/io/detail/openfoam/openfoam_format.hpp>

#ifndef CONCINO_COMPILED
#include <concino/io/detail/openfoam/read_openfoam.hpp>
#include <concino/io/detail/openfoam/write_openfoam.hpp>
#endif

namespace concino {

/// Reads a mesh from a polyMesh folder, whatever its name, or from a case with constant/polyMesh; no other format is
/// compiled.
/// Needs:  Loadable M, a volume.
/// Result: as load.
/// Cost:   as load.
/// Errors: as load, except that any name of a folder is accepted.
template<Loadable M>
M load_openfoam(const std::string& path, const load_options& options = {}) {
  return detail::load_with<M>(path, file_format::openfoam, options);
}

/// Writes a mesh to a polyMesh folder, whatever its name, or to constant/polyMesh of a case; no other format is
/// compiled.
/// Needs:  a volume mesh with points, of any type.
/// Result: as save.
/// Cost:   as save.
/// Errors: as save, except that any name of a folder is accepted.
template<EmbeddedMesh M>
void save_openfoam(const M& m, const std::string& path, const save_options& options = {}) {
  detail::save_with(m, path, file_format::openfoam, options);
}

}  // namespace concino
