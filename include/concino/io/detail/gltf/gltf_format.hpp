// The type of the glTF format. Its writer is defined in write_gltf.hpp.
#pragma once

#include <concino/io/format.hpp>

namespace concino {

/// The binary form of glTF 2.0, which is only written: triangles, with "normal", "texture" and "color" of verts, or
/// "color" of polys.
struct gltf_format {
  static constexpr std::string_view name = "gltf";
  static constexpr std::string_view extensions[] = {".glb"};
  static constexpr bool holds_surfaces = true, holds_volumes = false;
  static constexpr bool is_write_only = true;
  static constexpr bool has_binary = true;  // it is always binary

  static void write(write_context& out, flat_mesh& m);
};
static_assert(Format<gltf_format>);

namespace file_format {

inline constexpr gltf_format gltf{};

}  // namespace file_format

}  // namespace concino
