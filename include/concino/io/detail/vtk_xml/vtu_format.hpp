// The type of the XML format of VTK for surfaces and volumes. Its reader is defined in read_vtu.hpp, its writer in
// write_vtu.hpp.
#pragma once

#include <concino/io/detail/vtk_xml/vtk_signature.hpp>
#include <concino/io/format.hpp>

namespace concino {

/// The XML format of VTK, .vtu: surfaces of any polygons, volumes of any polyhedra, and properties of verts, faces,
/// polys and the mesh that consist of numbers.
struct vtu_format {
  static constexpr std::string_view name = "vtu";
  static constexpr std::string_view extensions[] = {".vtu"};
  static constexpr bool holds_surfaces = true, holds_volumes = true;
  static constexpr bool has_binary = true;
  static constexpr bool has_only_properties = true;
  static constexpr std::string_view signature = "<VTKFile type=\"UnstructuredGrid\"";

  static bool has_signature(std::string_view text) { return detail::is_vtk_xml(text, "UnstructuredGrid"); }
  template<std::derived_from<file_contents> Contents>  // a template so that programs that read only surfaces need not
                                                       // compile volumes
  static void read(const read_context& in, Contents& out);
  template<std::same_as<write_context> Context>  // a template so that programs that only read need not compile it
  static void write(Context& out, flat_mesh& m);
};
static_assert(Format<vtu_format>);

namespace file_format {

inline constexpr vtu_format vtu{};

}  // namespace file_format

}  // namespace concino
