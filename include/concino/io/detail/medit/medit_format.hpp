// The type of the MEDIT format. Its reader is defined in read_medit.hpp, its writer in write_medit.hpp.
#pragma once

#include <concino/io/detail/medit/medit_sections.hpp>
#include <concino/io/format.hpp>

namespace concino {

/// The MEDIT format, text and binary (.meshb): surfaces of triangles and quads; volumes of tets, hexes, prisms and
/// pyramids; "label" of all elements; marks of verts, edges, faces and polys; "normal" of verts.
struct medit_format {
  static constexpr std::string_view name = "medit";
  static constexpr std::string_view extensions[] = {".mesh", ".meshb"};
  static constexpr bool holds_surfaces = true, holds_volumes = true, has_binary = true;

  static constexpr std::string_view signature = "MeshVersionFormatted";

  static bool has_signature(std::string_view text) {
    if (detail::is_binary_medit(text)) return true;
    token_cursor in(text.substr(0, 4096), name, nullptr, '#');
    in.skip();
    return in.word() == "MeshVersionFormatted";
  }
  template<std::derived_from<file_contents> Contents>  // a template so that programs that read only surfaces need not
                                                       // compile volumes
  static void read(const read_context& in, Contents& out);
  static void write(write_context& out, flat_mesh& m);
};
static_assert(Format<medit_format>);

namespace file_format {

inline constexpr medit_format medit{};

}  // namespace file_format

}  // namespace concino
