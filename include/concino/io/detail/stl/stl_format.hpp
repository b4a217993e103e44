// The type of the STL format. Its reader is defined in read_stl.hpp, its writer in write_stl.hpp.
#pragma once

#include <concino/io/format.hpp>

#include <cstdint>

namespace concino {

namespace detail {

/// The number of triangles of a binary STL file. Needs: at least 84 bytes.
inline std::uint32_t stl_count(std::string_view text) {
  std::uint32_t n = 0;
  for (std::size_t i = 84; i-- > 80;) n = n << 8 | static_cast<unsigned char>(text[i]);
  return n;
}

/// Whether a text is as long as its binary header says: some begin with "solid" nevertheless.
inline bool is_stl_binary(std::string_view text) {
  return text.size() >= 84 && text.size() - 84 == std::uint64_t{50} * stl_count(text);
}

/// Whether the first word is "solid", in upper or lower case, and nothing says that the file is binary nevertheless.
inline bool is_stl_text(std::string_view text) {
  if (is_stl_binary(text) || (text.size() >= 84 && text.substr(0, 84).find('\0') != text.npos)) return false;
  token_cursor in(text.substr(0, 4096), {}, nullptr, 0);
  in.skip_space();
  const std::string_view w = in.word();
  for (std::size_t i = 0; i < w.size(); ++i)
    if (i >= 5 || (w[i] | 0x20) != "solid"[i]) return false;
  return w.size() == 5;
}

}  // namespace detail

/// The STL format, as text or binary: triangles by the points of their corners; "object" of polys in text, "attribute"
/// of polys in binary files.
struct stl_format {
  static constexpr std::string_view name = "stl";
  static constexpr std::string_view extensions[] = {".stl"};
  static constexpr bool holds_surfaces = true, holds_volumes = false;
  static constexpr bool has_binary = true;
  static constexpr std::string_view signature = "solid";

  static bool has_signature(std::string_view text) {
    return detail::is_stl_binary(text) || detail::is_stl_text(text);
  }
  static void read(const read_context& in, file_contents& out);
  static void write(write_context& out, flat_mesh& m);
};
static_assert(Format<stl_format>);

namespace file_format {

inline constexpr stl_format stl{};

}  // namespace file_format

}  // namespace concino
