// The type of the OFF format. Its reader is defined in read_off.hpp, its writer in write_off.hpp.
#pragma once

#include <concino/io/format.hpp>

namespace concino {

namespace detail {

/// The first word of an OFF file: [ST][C][N][4][n]OFF, or NC instead of CN.
struct off_word {
  bool texture = false, color = false, normal = false, homogeneous = false, any_dimension = false;

  /// How many characters the word has. 0: it is another one. The counts may follow without a blank.
  std::size_t parse(std::string_view word) {
    std::string_view rest = word;
    const auto take = [&](std::string_view prefix) {
      const bool is = rest.starts_with(prefix);
      if (is) rest.remove_prefix(prefix.size());
      return is;
    };
    texture = take("ST");
    color = take("C");
    normal = take("N");
    color = color || take("C");
    homogeneous = take("4");
    any_dimension = take("n");
    if (!take("OFF") || rest.find_first_not_of("0123456789") != rest.npos) return 0;
    return word.size() - rest.size();
  }
};

}  // namespace detail

/// The OFF format: verts and polygons of any size; "color" of verts and polys, "label" of polys that have no colour,
/// "normal" and "texture" of verts.
struct off_format {
  static constexpr std::string_view name = "off";
  static constexpr std::string_view extensions[] = {".off"};
  static constexpr bool holds_surfaces = true, holds_volumes = false;
  static constexpr bool has_binary = true;
  static constexpr std::string_view signature = "OFF";

  static bool has_signature(std::string_view text) {
    token_cursor in(text.substr(0, 4096), name, nullptr, '#');
    in.skip();
    return detail::off_word().parse(in.word()) > 0;
  }
  static void read(const read_context& in, file_contents& out);
  static void write(write_context& out, flat_mesh& m);
};
static_assert(Format<off_format>);

namespace file_format {

inline constexpr off_format off{};

}  // namespace file_format

}  // namespace concino
