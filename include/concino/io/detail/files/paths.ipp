// Definitions of paths.hpp.
#pragma once

#include <concino/core/message.hpp>
#include <concino/io/detail/files/io_errors.hpp>
#include <concino/io/detail/files/paths.hpp>

#include <cerrno>
#include <climits>
#include <cstdlib>

#include <unistd.h>

namespace concino::detail {

CONCINO_INLINE void check_path(std::string_view path) {
  if (path.find('\0') == path.npos) return;
  std::string printable;
  for (const char c : path) printable.append(c ? std::string_view(&c, 1) : std::string_view("\\0"));
  core::throw_joined<io_error>({printable, ": a path cannot contain a null character"});
}

CONCINO_INLINE std::string resolve_links(const std::string& path) {
  std::string at = path;
  for (int links = 0; links < 40; ++links) {
    char buffer[PATH_MAX + 1];
    if (::realpath(at.c_str(), buffer)) return buffer;
    const ::ssize_t size = ::readlink(at.c_str(), buffer, PATH_MAX);
    if (size < 0) return at;  // not a link, or it does not exist
    const std::string_view to(buffer, static_cast<std::size_t>(size));
    at = core::joined({std::string_view(at).substr(0, to.starts_with('/') ? 0 : at.rfind('/') + 1), to});
  }
  throw_io_error(path, "cannot be written", ELOOP);
}

}  // namespace concino::detail
