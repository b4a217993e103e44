// Reads and writes TetGen's volumes of tets: .node and .ele, .face and .edge.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/detail/formats/load_with.hpp>
#include <concino/io/detail/formats/save_with.hpp>
#include <concino/io/detail/tetgen/ele_format.hpp>

#ifndef CONCINO_COMPILED
#include <concino/io/detail/tetgen/read_ele.hpp>
#include <concino/io/detail/tetgen/write_ele.hpp>
#endif

namespace concino {

/// Reads a mesh from x.ele or x.node and the files beside it; no other format is compiled.
/// Needs:  Loadable M, a volume.
/// Result: as load.
/// Cost:   as load.
/// Errors: as load, except that any extension is accepted: unless it is .node, the file lists tets.
template<Loadable M>
M load_ele(const std::string& path, const load_options& options = {}) {
  return detail::load_with<M>(path, file_format::ele, options);
}

/// Writes a mesh of tets to x.ele or x.node and the files beside it; no other format is compiled.
/// Needs:  a volume mesh with points, of any type.
/// Result: as save.
/// Cost:   as save.
/// Errors: as save, except that any extension is accepted: unless it is .node, the file lists tets.
template<EmbeddedMesh M>
void save_ele(const M& m, const std::string& path, const save_options& options = {}) {
  detail::save_with(m, path, file_format::ele, options);
}

}  // namespace concino
