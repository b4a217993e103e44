// The type of the OpenFOAM format. Its reader is defined in read_openfoam.hpp, its writer in write_openfoam.hpp.
#pragma once

#include <concino/io/format.hpp>

namespace concino {

/// A polyMesh folder of OpenFOAM: volumes of any polyhedra, "label" of faces (patches) and polys (cellZones), and their
/// names in "label_names" of the mesh.
struct openfoam_format {
  static constexpr std::string_view name = "openfoam";
  static constexpr std::string_view extensions[] = {"polyMesh"};
  static constexpr bool holds_surfaces = false, holds_volumes = true;
  static constexpr bool has_binary = true, holds_faces = true;
  static constexpr bool is_folder = true;
  static constexpr std::string_view folder_file = "points", folder_in_case = "constant/polyMesh";
  template<std::same_as<volume_contents> Contents>  // a template only so that programs that read no volumes need not
                                                    // compile it
  static void read(const read_context& in, Contents& out);
  static void write(write_context& out, flat_mesh& m);
};
static_assert(Format<openfoam_format>);

namespace file_format {

inline constexpr openfoam_format openfoam{};

}  // namespace file_format

}  // namespace concino
