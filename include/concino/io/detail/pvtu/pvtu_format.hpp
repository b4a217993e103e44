// The type of VTK's format of meshes in pieces. Its reader is defined in read_pvtu.hpp; save_pvtu writes such files.
#pragma once

#include <concino/io/detail/vtk_xml/vtk_signature.hpp>
#include <concino/io/format.hpp>

namespace concino {

/// The .pvtu files of VTK: meshes in pieces, each a .vtu file, with properties of verts, faces, polys and the mesh that
/// consist of numbers. save does not write them, as it has no parts; save_pvtu does.
struct pvtu_format {
  static constexpr std::string_view name = "pvtu";
  static constexpr std::string_view extensions[] = {".pvtu"};
  static constexpr bool holds_surfaces = true, holds_volumes = true, is_read_only = true;
  static constexpr bool has_only_properties = true;
  static constexpr std::string_view signature = "<VTKFile type=\"PUnstructuredGrid\"";

  static bool has_signature(std::string_view text) { return detail::is_vtk_xml(text, "PUnstructuredGrid"); }
  template<std::derived_from<file_contents> Contents>  // a template so that programs that read only surfaces need not
                                                       // compile volumes
  static void read(const read_context& in, Contents& out);
};
static_assert(Format<pvtu_format>);

namespace file_format {

inline constexpr pvtu_format pvtu{};

}  // namespace file_format

}  // namespace concino
