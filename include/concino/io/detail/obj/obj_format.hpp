// The type of the OBJ format. Its reader is defined in read_obj.hpp, its writer in write_obj.hpp.
#pragma once

#include <concino/io/format.hpp>

namespace concino {

/// The OBJ format: verts and polygons of any size; "color" of verts and polys, "label", "object", "group" and
/// "material" of polys, "materials" of the mesh; "texture" and "normal" of corners.
struct obj_format {
  static constexpr std::string_view name = "obj";
  static constexpr std::string_view extensions[] = {".obj"};
  static constexpr bool holds_surfaces = true, holds_volumes = false;
  static void read(const read_context& in, file_contents& out);
  static void write(write_context& out, flat_mesh& m);
};
static_assert(Format<obj_format>);

namespace file_format {

inline constexpr obj_format obj{};

}  // namespace file_format

}  // namespace concino
