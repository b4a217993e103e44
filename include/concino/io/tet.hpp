// Reads and writes .tet, volumes of tets, hexes, prisms and pyramids.
#pragma once

#include <concino/io/detail/tet/tet_format.hpp>
#include <concino/core/compiled.hpp>
#include <concino/io/detail/formats/load_with.hpp>
#include <concino/io/detail/formats/save_with.hpp>

#ifndef CONCINO_COMPILED
#include <concino/io/detail/tet/read_tet.hpp>
#include <concino/io/detail/tet/write_tet.hpp>
#endif

namespace concino {

/// Reads a mesh from a .tet file, whatever its extension; no other format is compiled.
/// Needs:  Loadable M, a volume.
/// Result: as load.
/// Cost:   as load.
/// Errors: as load, except that any extension is accepted.
template<Loadable M>
M load_tet(const std::string& path, const load_options& options = {}) {
  return detail::load_with<M>(path, file_format::tet, options);
}

/// Writes a mesh to a .tet file, whatever its extension; no other format is compiled.
/// Needs:  a volume mesh with points, of any type.
/// Result: as save.
/// Cost:   as save.
/// Errors: as save, except that any extension is accepted.
template<EmbeddedMesh M>
void save_tet(const M& m, const std::string& path, const save_options& options = {}) {
  detail::save_with(m, path, file_format::tet, options);
}

}  // namespace concino
