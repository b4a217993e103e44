// Reads and writes .vtp files of VTK, as text or binary: any surface, with properties. Compressed files need
// <concino/adapters/zlib.hpp>.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/detail/formats/load_with.hpp>
#include <concino/io/detail/formats/save_with.hpp>
#include <concino/io/detail/vtk_xml/vtp_format.hpp>

#ifndef CONCINO_COMPILED
#include <concino/io/detail/vtk_xml/read_vtp.hpp>
#include <concino/io/detail/vtk_xml/write_vtp.hpp>
#endif

namespace concino {

/// Reads a mesh from a .vtp file, whatever its extension; no other format is compiled.
/// Needs:  Loadable M.
/// Result: as load.
/// Cost:   as load.
/// Errors: as load, except that any extension is accepted.
template<Loadable M>
M load_vtp(const std::string& path, const load_options& options = {}) {
  return detail::load_with<M>(path, file_format::vtp, options);
}

/// Writes a mesh to a .vtp file of version 1.0, whatever its extension; no other format is compiled.
/// Needs:  a mesh with points, of any type.
/// Result: as save.
/// Cost:   as save.
/// Errors: as save, except that any extension is accepted.
template<EmbeddedMesh M>
void save_vtp(const M& m, const std::string& path, const save_options& options = {}) {
  detail::save_with(m, path, file_format::vtp, options);
}

}  // namespace concino
