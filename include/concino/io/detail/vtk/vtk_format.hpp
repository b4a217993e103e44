// The type of the legacy format of VTK. Its reader is defined in read_vtk.hpp, its writer in write_vtk.hpp.
#pragma once

#include <concino/io/format.hpp>

namespace concino {

/// The legacy format of VTK, .vtk, as text or binary: surfaces of any polygons, volumes of any polyhedra, and
/// properties of verts, faces, polys and the mesh that consist of numbers.
struct vtk_format {
  static constexpr std::string_view name = "vtk";
  static constexpr std::string_view extensions[] = {".vtk"};
  static constexpr bool holds_surfaces = true, holds_volumes = true;
  static constexpr bool has_binary = true;
  static constexpr bool has_only_properties = true;
  static constexpr std::string_view signature = "# vtk DataFile";

  static bool has_signature(std::string_view text) { return text.starts_with(signature); }
  template<std::derived_from<file_contents> Contents>  // a template so that programs that read only surfaces need not
                                                       // compile volumes
  static void read(const read_context& in, Contents& out);
  template<std::same_as<write_context> Context>  // a template so that programs that only read need not compile it
  static void write(Context& out, flat_mesh& m);
};
static_assert(Format<vtk_format>);

namespace file_format {

inline constexpr vtk_format vtk{};

}  // namespace file_format

}  // namespace concino
