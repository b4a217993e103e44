// Checks paths and resolves symbolic links.
#pragma once

#include <concino/core/compiled.hpp>

#include <string>
#include <string_view>

namespace concino::detail {

/// Checks that a path contains no character of value 0, at which the system would end the path and open another file.
/// Errors: io_error that shows its position.
void check_path(std::string_view path);

/// The path with all links followed, whether or not the file exists.
std::string resolve_links(const std::string& path);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/io/detail/files/paths.ipp>
#endif
