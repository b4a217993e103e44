// Paths that the system would take for others.
#pragma once

#include <concino/core/compiled.hpp>

#include <string>
#include <string_view>

namespace concino::detail {

/// A character of value 0 would end the path for the system, which then opened another file.
/// Errors: io_error that shows where it stands.
void check_path(std::string_view path);

/// The path with all links followed, whether or not there is a file in the end.
std::string resolve_links(const std::string& path);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/io/detail/paths.ipp>
#endif
