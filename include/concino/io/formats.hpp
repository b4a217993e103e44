// The file formats, and which one a path asks for.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/io/detail/paths.hpp>

#include <string>
#include <string_view>

namespace concino {

enum class file_format {
  by_extension,
  obj,    // .obj: surfaces, Wavefront
  off,    // .off: surfaces, Geomview
  medit,  // .mesh: surfaces of triangles and quads; volumes of tets, hexes, prisms and pyramids, MEDIT ASCII
  hedra,  // .hedra: volumes of any polyhedra, Cinolib
};

namespace detail {

struct format_row {
  file_format format;
  std::string_view extension;
};
inline constexpr format_row known_formats[] = {
    {file_format::obj, ".obj"}, {file_format::off, ".off"}, {file_format::medit, ".mesh"}, {file_format::hedra, ".hedra"}};

inline std::string_view extension_of(file_format f) {
  for (const format_row& row : known_formats)
    if (row.format == f) return row.extension;
  return "";
}

/// Upper and lower case mean the same. Errors: as check_path; unsupported if the extension is not known, naming those that are.
[[gnu::noinline, gnu::cold]] inline file_format format_of(std::string_view path, file_format asked) {
  check_path(path);
  if (asked != file_format::by_extension) return asked;
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; };
  std::string known;
  for (const format_row& row : known_formats) {
    if (path.size() > row.extension.size()) {
      const std::string_view tail = path.substr(path.size() - row.extension.size());
      std::size_t same = 0;
      while (same < tail.size() && lower(tail[same]) == row.extension[same]) ++same;
      if (same == tail.size()) return row.format;
    }
    known = core::joined({known, known.empty() ? "" : ", ", row.extension});
  }
  core::throw_joined<unsupported>({path, ": the extension names no format known here; known are ", known});
}

}  // namespace detail

}  // namespace concino
