// Bodies of paths.hpp: checks paths and resolves symbolic links.
#pragma once

#include <concino/core/message.hpp>
#include <concino/io/detail/files/io_errors.hpp>
#include <concino/io/detail/files/paths.hpp>
#include <concino/io/detail/files/system_files.hpp>

#include <cerrno>

namespace concino::detail {

CONCINO_INLINE void check_path(std::string_view path) {
  if (path.find('\0') == path.npos) return;
  std::string printable;
  for (const char c : path) printable.append(c ? std::string_view(&c, 1) : std::string_view("\\0"));
  core::throw_joined<io_error>({printable, ": a path cannot contain a null character"});
}

CONCINO_INLINE std::string resolve_links(const std::string& path) {
  std::string at = with_slashes(path);
  for (int links = 0; links < 40; ++links) {
    if (std::string real = real_path(at); !real.empty()) return real;
    std::string target = link_target(at);
    if (target.empty()) return at;  // not a link, or it does not exist
    at.swap(target);
  }
  throw_io_error(path, "cannot be written", ELOOP);
}

}  // namespace concino::detail
