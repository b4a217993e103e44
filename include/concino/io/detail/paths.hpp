// Paths that the system would take for others.
#pragma once

#include <concino/core/message.hpp>
#include <concino/io/detail/io_errors.hpp>

#include <cerrno>
#include <climits>
#include <cstdlib>
#include <string>
#include <string_view>

#include <unistd.h>

namespace concino::detail {

/// A character of value 0 would end the path for the system, which then opened another file.
/// Errors: io_error that shows where it stands.
[[gnu::noinline, gnu::cold]] inline void check_path(std::string_view path) {
  if (path.find('\0') == path.npos) return;
  std::string shown;
  for (const char c : path) shown.append(c ? std::string_view(&c, 1) : std::string_view("\\0"));
  core::throw_joined<io_error>({shown, ": no path holds a character of value 0"});
}

/// The path with all links followed, whether or not there is a file in the end.
[[gnu::noinline, gnu::cold]] inline std::string resolve_links(const std::string& path) {
  std::string at = path;
  for (int links = 0; links < 40; ++links) {
    char buffer[PATH_MAX + 1];
    if (::realpath(at.c_str(), buffer)) return buffer;
    const ::ssize_t size = ::readlink(at.c_str(), buffer, PATH_MAX);
    if (size < 0) return at;  // no link, or nothing there
    const std::string_view to(buffer, static_cast<std::size_t>(size));
    at = core::joined({std::string_view(at).substr(0, to.starts_with('/') ? 0 : at.rfind('/') + 1), to});
  }
  throw_io_error(path, "cannot be written", ELOOP);
}

}  // namespace concino::detail
