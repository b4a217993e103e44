// Reads and writes .ovm, the text format of OpenVolumeMesh.
#pragma once

#include <concino/io/detail/ovm/ovm_format.hpp>
#include <concino/core/compiled.hpp>
#include <concino/io/detail/formats/load_with.hpp>
#include <concino/io/detail/formats/save_with.hpp>

#ifndef CONCINO_COMPILED
#include <concino/io/detail/ovm/read_ovm.hpp>
#include <concino/io/detail/ovm/write_ovm.hpp>
#endif

namespace concino {

/// Reads a mesh from an .ovm file, whatever its extension; no other format is compiled.
/// Needs:  Loadable M, a volume.
/// Result: as load.
/// Cost:   as load.
/// Errors: as load, except that any extension is accepted.
template<Loadable M>
M load_ovm(const std::string& path, const load_options& options = {}) {
  return detail::load_with<M>(path, file_format::ovm, options);
}

/// Writes a mesh to an .ovm file, whatever its extension; no other format is compiled.
/// Needs:  a volume mesh with points, of any type.
/// Result: as save.
/// Cost:   as save.
/// Errors: as save, except that any extension is accepted.
template<EmbeddedMesh M>
void save_ovm(const M& m, const std::string& path, const save_options& options = {}) {
  detail::save_with(m, path, file_format::ovm, options);
}

}  // namespace concino
