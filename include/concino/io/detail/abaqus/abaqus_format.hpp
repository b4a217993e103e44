// The type of the input files of Abaqus. Its reader is defined in read_abaqus.hpp.
#pragma once

#include <concino/io/format.hpp>

namespace concino {

/// The .inp files of Abaqus and CalculiX, only read: surfaces of triangles and quads; volumes of tets, pyramids, prisms
/// and hexes. Each set is a property (int, 0 or 1) of verts or polys, by its name.
struct abaqus_format {
  static constexpr std::string_view name = "abaqus";
  static constexpr std::string_view extensions[] = {".inp"};
  static constexpr bool holds_surfaces = true, holds_volumes = true, is_read_only = true;
  template<std::derived_from<file_contents> Contents>  // a template so that programs that read only surfaces need not
                                                       // compile volumes
  static void read(const read_context& in, Contents& out);
};
static_assert(Format<abaqus_format>);

namespace file_format {

inline constexpr abaqus_format abaqus{};

}  // namespace file_format

}  // namespace concino
