// Reads and writes MEDIT .mesh, ASCII: triangles and quads, or tets, hexes, prisms and pyramids.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/detail/formats/load_with.hpp>
#include <concino/io/detail/formats/save_with.hpp>
#include <concino/io/detail/medit/medit_format.hpp>

#ifndef CONCINO_COMPILED
#include <concino/io/detail/medit/read_medit.hpp>
#include <concino/io/detail/medit/write_medit.hpp>
#endif

namespace concino {

/// Reads a mesh from a MEDIT file, whatever its extension; no other format is compiled.
/// Needs:  Loadable M.
/// Result: as load.
/// Cost:   as load.
/// Errors: as load, except that any extension is accepted.
template<Loadable M>
M load_medit(const std::string& path, const load_options& options = {}) {
  return detail::load_with<M>(path, file_format::medit, options);
}

/// Writes a mesh to a MEDIT file, whatever its extension; no other format is compiled.
/// Needs:  a mesh with points, of any type.
/// Result: as save.
/// Cost:   as save.
/// Errors: as save, except that any extension is accepted.
template<EmbeddedMesh M>
void save_medit(const M& m, const std::string& path, const save_options& options = {}) {
  detail::save_with(m, path, file_format::medit, options);
}

}  // namespace concino
