// The paths of the files that TetGen names alike: x.node, x.ele, x.face, x.edge.
#pragma once

#include <concino/core/message.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace concino::detail {

/// Whether a path has an extension, in upper or lower case; `extension` is in lower case.
inline bool ends_in(std::string_view path, std::string_view extension) {
  if (path.size() <= extension.size()) return false;
  const std::string_view tail = path.substr(path.size() - extension.size());
  for (std::size_t i = 0; i < tail.size(); ++i)
    if (tail[i] != extension[i] && (tail[i] < 'A' || tail[i] > 'Z' || (tail[i] | 0x20) != extension[i])) return false;
  return true;
}

/// The path of the file beside `path` with another extension, which is in upper case if that of the path is.
inline std::string tetgen_path(std::string_view path, std::string_view extension) {
  const std::size_t name = path.find_last_of("/\\") + 1, dot = path.rfind('.');  // npos + 1 is 0
  const bool has_extension = dot != path.npos && dot > name;
  std::string other = core::joined({has_extension ? path.substr(0, dot) : path, extension});
  if (has_extension && path.size() > dot + 1 && path[dot + 1] >= 'A' && path[dot + 1] <= 'Z')
    for (std::size_t i = other.size() - extension.size(); i < other.size(); ++i)
      if (other[i] >= 'a' && other[i] <= 'z') other[i] = static_cast<char>(other[i] - ('a' - 'A'));
  return other;
}

}  // namespace concino::detail
