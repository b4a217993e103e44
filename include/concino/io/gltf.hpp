// Writes glTF 2.0 as binary files, .glb, for viewers and web pages.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/detail/formats/save_with.hpp>
#include <concino/io/detail/gltf/gltf_format.hpp>

#ifndef CONCINO_COMPILED
#include <concino/io/detail/gltf/write_gltf.hpp>
#endif

namespace concino {

/// Writes a mesh to a .glb file, whatever its extension; no other format is compiled.
/// Needs:  a mesh with points, of any type: a surface, or a volume with options.as_boundary.
/// Result: as save.
/// Cost:   as save.
/// Errors: as save, except that any extension is accepted.
template<EmbeddedMesh M>
void save_gltf(const M& m, const std::string& path, const save_options& options = {}) {
  detail::save_with(m, path, file_format::gltf, options);
}

}  // namespace concino
