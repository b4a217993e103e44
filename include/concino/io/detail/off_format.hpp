// The type of the OFF format. Its reader is defined in read_off.hpp, its writer in write_off.hpp.
#pragma once

#include <concino/io/format.hpp>

namespace concino {

/// The OFF format: verts and polygons of any size; "color" of verts and polys, "label" of polys that have no colour, "normal" and "texture" of verts.
struct off_format {
  static constexpr std::string_view name = "off";
  static constexpr std::string_view extensions[] = {".off"};
  static constexpr bool holds_surfaces = true, holds_volumes = false;
  static constexpr bool has_binary = true;
  static constexpr std::string_view signature = "OFF";

  static bool has_signature(std::string_view text) {
    token_cursor in(text.substr(0, 4096), name, nullptr, '#');
    in.skip();
    std::string_view word = in.word();
    for (const std::string_view prefix : {"ST", "C", "N", "4", "n"})
      if (word.starts_with(prefix)) word.remove_prefix(prefix.size());
    return word == "OFF";
  }
  static void read(const read_context& in, file_contents& out);
  static void write(write_context& out, flat_mesh& m);
};
static_assert(Format<off_format>);

namespace file_format {

inline constexpr off_format off{};

}  // namespace file_format

}  // namespace concino
