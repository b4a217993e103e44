// Reads and writes the .msh files of Gmsh, versions 2.2 and 4.1, text and binary: triangles and quads, or tets, hexes,
// prisms and pyramids, with labels and their names.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/detail/formats/load_with.hpp>
#include <concino/io/detail/formats/save_with.hpp>
#include <concino/io/detail/gmsh/gmsh_format.hpp>

#ifndef CONCINO_COMPILED
#include <concino/io/detail/gmsh/read_gmsh.hpp>
#include <concino/io/detail/gmsh/write_gmsh.hpp>
#endif

namespace concino {

/// Reads a mesh from a Gmsh file, whatever its extension; no other format is compiled.
/// Needs:  Loadable M.
/// Result: as load.
/// Cost:   as load.
/// Errors: as load, except that any extension is accepted.
template<Loadable M>
M load_gmsh(const std::string& path, const load_options& options = {}) {
  return detail::load_with<M>(path, file_format::gmsh, options);
}

/// Writes a mesh to a Gmsh file of version 2.2, whatever its extension; no other format is compiled. All programs that
/// read version 4.1 read that one too, and many read no other.
/// Needs:  a mesh with points, of any type.
/// Result: as save.
/// Cost:   as save.
/// Errors: as save, except that any extension is accepted.
template<EmbeddedMesh M>
void save_gmsh(const M& m, const std::string& path, const save_options& options = {}) {
  detail::save_with(m, path, file_format::gmsh, options);
}

}  // namespace concino
