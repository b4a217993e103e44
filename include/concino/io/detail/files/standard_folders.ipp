// Names of files and folders where the system is not POSIX: definitions of the part of system_files.hpp that changes
// folders.
#pragma once

#if !defined(__unix__) && !defined(__APPLE__)

#include <concino/io/detail/files/standard_files.ipp>
#include <concino/io/detail/files/system_files.hpp>

#include <string>
#include <system_error>

namespace concino::detail {

CONCINO_INLINE bool rename_file(const std::string& path, const std::string& new_path) noexcept {
  try {
    std::error_code error;
    std::filesystem::rename(system_path(path), system_path(new_path), error);
    return !error;
  } catch (...) {  // no memory for the path
    return false;
  }
}

CONCINO_INLINE bool create_folder(const std::string& path) {
  std::error_code error;
  const bool is_new = std::filesystem::create_directory(system_path(path), error);
  if (error) set_errno(error);
  return is_new;
}

CONCINO_INLINE bool remove_folder(const std::string& path) noexcept { return remove_file(path); }

}  // namespace concino::detail

#endif
