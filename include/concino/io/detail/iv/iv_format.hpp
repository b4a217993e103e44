// The type of the Open Inventor format, which is only read. Its reader is defined in read_iv.hpp.
#pragma once

#include <concino/io/format.hpp>

namespace concino {

/// The Open Inventor format, ASCII, read only: polygons of any size; "label" of polys, from the material indices of
/// faces.
struct iv_format {
  static constexpr std::string_view name = "iv";
  static constexpr std::string_view extensions[] = {".iv"};
  static constexpr std::string_view signature = "#Inventor";
  static constexpr bool holds_surfaces = true, holds_volumes = false, is_read_only = true;
  static bool has_signature(std::string_view text) { return text.starts_with(signature); }
  static void read(const read_context& in, file_contents& out);
};
static_assert(Format<iv_format>);

namespace file_format {

inline constexpr iv_format iv{};

}  // namespace file_format

}  // namespace concino
