// The type of the Gmsh format. Its reader is defined in read_gmsh.hpp, its writer in write_gmsh.hpp.
#pragma once

#include <concino/io/format.hpp>

namespace concino {

/// The mesh format of Gmsh, .msh, as text or binary: surfaces of triangles and quads; volumes of tets, hexes, prisms
/// and pyramids; "label" of all elements, with names; numbers of verts and elements as properties.
struct gmsh_format {
  static constexpr std::string_view name = "gmsh";
  static constexpr std::string_view extensions[] = {".msh"};
  static constexpr bool holds_surfaces = true, holds_volumes = true, has_binary = true;

  static constexpr std::string_view signature = "$MeshFormat";

  static bool has_signature(std::string_view text) {
    token_cursor in(text, name, nullptr, 0);
    for (in.skip(); std::string_view(in.at, in.left()).starts_with("$Comments"); in.skip()) {
      constexpr std::string_view end = "$EndComments";
      const std::size_t after = std::string_view(in.at, in.left()).find(end);
      if (after == std::string_view::npos) return false;
      in.at += after + end.size();
    }
    return std::string_view(in.at, in.left()).starts_with(signature);
  }
  template<std::derived_from<file_contents> Contents>  // a template so that programs that read only surfaces need not
                                                       // compile volumes
  static void read(const read_context& in, Contents& out);
  static void write(write_context& out, flat_mesh& m);
};
static_assert(Format<gmsh_format>);

namespace file_format {

inline constexpr gmsh_format gmsh{};

}  // namespace file_format

}  // namespace concino
