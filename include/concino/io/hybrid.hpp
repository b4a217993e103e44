// Reads and writes .hybrid, the format of hex-dominant meshes.
#pragma once

#include <concino/io/detail/hybrid/hybrid_format.hpp>
#include <concino/core/compiled.hpp>
#include <concino/io/detail/formats/load_with.hpp>
#include <concino/io/detail/formats/save_with.hpp>

#ifndef CONCINO_COMPILED
#include <concino/io/detail/hybrid/read_hybrid.hpp>
#include <concino/io/detail/hybrid/write_hybrid.hpp>
#endif

namespace concino {

/// Reads a mesh from a .hybrid file, whatever its extension; no other format is compiled.
/// Needs:  Loadable M, a volume.
/// Result: as load.
/// Cost:   as load.
/// Errors: as load, except that any extension is accepted.
template<Loadable M>
M load_hybrid(const std::string& path, const load_options& options = {}) {
  return detail::load_with<M>(path, file_format::hybrid, options);
}

/// Writes a mesh to a .hybrid file, whatever its extension; no other format is compiled.
/// Needs:  a volume mesh with points, of any type.
/// Result: as save.
/// Cost:   as save.
/// Errors: as save, except that any extension is accepted.
template<EmbeddedMesh M>
void save_hybrid(const M& m, const std::string& path, const save_options& options = {}) {
  detail::save_with(m, path, file_format::hybrid, options);
}

}  // namespace concino
