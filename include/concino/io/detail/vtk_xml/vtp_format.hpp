// The type of the XML format of VTK for surfaces. Its reader is defined in read_vtp.hpp, its writer in write_vtp.hpp.
#pragma once

#include <concino/io/detail/vtk_xml/vtk_signature.hpp>
#include <concino/io/format.hpp>

namespace concino {

/// The XML format of VTK, .vtp: surfaces of any polygons, and properties of verts, polys and
/// the mesh that consist of numbers.
struct vtp_format {
  static constexpr std::string_view name = "vtp";
  static constexpr std::string_view extensions[] = {".vtp"};
  static constexpr bool holds_surfaces = true, holds_volumes = false;
  static constexpr bool has_binary = true;
  static constexpr bool has_only_properties = true;
  static constexpr std::string_view signature = "<VTKFile type=\"PolyData\"";

  static bool has_signature(std::string_view text) { return detail::is_vtk_xml(text, "PolyData"); }
  static void read(const read_context& in, file_contents& out);
  template<std::same_as<write_context> Context>  // a template so that programs that only read need not compile it
  static void write(Context& out, flat_mesh& m);
};
static_assert(Format<vtp_format>);

namespace file_format {

inline constexpr vtp_format vtp{};

}  // namespace file_format

}  // namespace concino
