// What stands for an open file: a descriptor on POSIX systems, a std::FILE* on others.
#pragma once

#if !defined(__unix__) && !defined(__APPLE__)
#include <cstdio>
#endif

namespace concino::detail {

#if defined(__unix__) || defined(__APPLE__)
using file_handle = int;
inline constexpr file_handle no_file = -1;
inline constexpr bool can_map_files = true;
#else
using file_handle = std::FILE*;
inline constexpr file_handle no_file = nullptr;
inline constexpr bool can_map_files = false;
#endif

}  // namespace concino::detail
