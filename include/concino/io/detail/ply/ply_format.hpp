// The type of the PLY format. Its reader is defined in read_ply.hpp, its writer in write_ply.hpp.
#pragma once

#include <concino/io/format.hpp>

namespace concino {

/// The PLY format, the polygon file format of Stanford, as text or binary: verts and polygons of any size, and all
/// properties of verts, edges and polys that consist of numbers or of lists of numbers.
struct ply_format {
  static constexpr std::string_view name = "ply";
  static constexpr std::string_view extensions[] = {".ply"};
  static constexpr bool holds_surfaces = true, holds_volumes = false;
  static constexpr bool has_binary = true;
  static constexpr std::string_view signature = "ply";

  static bool has_signature(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    return text.size() > 3 && text.starts_with("ply") && detail::is_line_end(text[3]);
  }
  static void read(const read_context& in, file_contents& out);
  static void write(write_context& out, flat_mesh& m);
};
static_assert(Format<ply_format>);

namespace file_format {

inline constexpr ply_format ply{};

}  // namespace file_format

}  // namespace concino
