// Reads and writes Wavefront OBJ: surfaces with colours, groups, objects and materials.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/detail/formats/load_with.hpp>
#include <concino/io/detail/formats/save_with.hpp>
#include <concino/io/detail/obj/obj_format.hpp>

#ifndef CONCINO_COMPILED
#include <concino/io/detail/obj/read_obj.hpp>
#include <concino/io/detail/obj/write_obj.hpp>
#endif

namespace concino {

/// Reads a mesh from an OBJ file, whatever its extension; no other format is compiled.
/// Needs:  Loadable M, a surface.
/// Result: as load.
/// Cost:   as load.
/// Errors: as load, except that any extension is accepted.
template<Loadable M>
M load_obj(const std::string& path, const load_options& options = {}) {
  return detail::load_with<M>(path, file_format::obj, options);
}

/// Writes a mesh to an OBJ file, whatever its extension; no other format is compiled.
/// Needs:  a surface mesh with points, of any type.
/// Result: as save.
/// Cost:   as save.
/// Errors: as save, except that any extension is accepted.
template<EmbeddedMesh M>
void save_obj(const M& m, const std::string& path, const save_options& options = {}) {
  detail::save_with(m, path, file_format::obj, options);
}

}  // namespace concino
