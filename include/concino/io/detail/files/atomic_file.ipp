// Bodies of atomic_file.hpp: atomic replacement of a file, as far as it is the same on all systems. The rest is in
// posix_atomic_file.ipp and standard_files.ipp.
#pragma once

#include <concino/core/hash_bytes.hpp>
#include <concino/core/message.hpp>
#include <concino/io/atomic_file.hpp>
#include <concino/io/detail/files/io_errors.hpp>
#include <concino/io/detail/files/paths.hpp>
#include <concino/io/detail/files/system_files.hpp>

#include <cerrno>

namespace concino {

[[noreturn, gnu::noinline, gnu::cold]] CONCINO_INLINE void atomic_file::fail(const char* what) const {
  detail::throw_io_error(path_, what, errno);
}

CONCINO_INLINE std::string atomic_file::temporary_name(std::string_view target) {
  return core::joined({".concino-", core::hash_text(target)});
}

CONCINO_INLINE atomic_file::atomic_file(const std::string& path, const atomic_file_options& options)
    : path_(path), options_(options) {
  detail::check_path(path);
  const std::string target = detail::resolve_links(path);
  const std::size_t slash = target.rfind('/') + 1;
  folder_path_ = target.substr(0, slash);
  name_ = target.substr(slash);
  if (name_.empty()) detail::throw_io_error(path_, "cannot be written", target.empty() ? ENOENT : EISDIR);
  try {
    open();
  } catch (...) {
    close();
    throw;
  }
}

CONCINO_INLINE atomic_file::~atomic_file() { close(); }

}  // namespace concino
