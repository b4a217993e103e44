// Files where the system is not POSIX, by the standard library alone: definitions of system_files.hpp, and of the part
// of atomic_file.hpp that depends on the system. atomic_file.hpp and file_text.hpp say what is lost. Paths are UTF-8,
// on Windows too.
#pragma once

#if !defined(__unix__) && !defined(__APPLE__)

#include <concino/core/hash_bytes.hpp>
#include <concino/core/message.hpp>
#include <concino/io/atomic_file.hpp>
#include <concino/io/detail/files/io_errors.hpp>
#include <concino/io/detail/files/system_files.hpp>

#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

namespace concino::detail {

/// Errors: io_error if the path is not UTF-8.
inline std::filesystem::path system_path(const std::string& path) {
  try {
    return std::filesystem::path(std::u8string(path.begin(), path.end()));
  } catch (const std::system_error&) {
    core::throw_joined<io_error>({path, ": a path must be UTF-8"});
  }
}

inline std::string text_of_path(const std::filesystem::path& path) {
  const std::u8string text = path.generic_u8string();
  return std::string(text.begin(), text.end());
}

/// Sets errno to the reason of an error.
inline void set_errno(const std::error_code& error) {
  const std::error_condition reason = error.default_error_condition();
  errno = reason.category() == std::generic_category() ? reason.value() : EIO;
}

inline std::FILE* open_stream(const std::filesystem::path& path, bool to_write) {
#ifdef _WIN32
  return ::_wfopen(path.c_str(), to_write ? L"wb" : L"rb");
#else
  return std::fopen(path.c_str(), to_write ? "wb" : "rb");
#endif
}

inline file_kind kind_of(const std::filesystem::file_status& status) {
  using type = std::filesystem::file_type;
  switch (status.type()) {
    case type::none:
    case type::not_found: return file_kind::none;
    case type::regular: return file_kind::regular;
    case type::directory: return file_kind::folder;
    case type::fifo: return file_kind::pipe;
    default: return file_kind::other;
  }
}

/// The status of a file whose kind is known. A file is identified by its real path.
inline file_status status_from(const std::filesystem::path& path, const std::filesystem::file_status& status,
                               const std::error_code& error) {
  file_status s;
  s.kind = kind_of(status);
  if (s.kind == file_kind::none) {
    if (status.type() == std::filesystem::file_type::not_found) errno = ENOENT;
    else set_errno(error);
    return s;
  }
  std::error_code ignored;
  s.number = core::hash_bytes(text_of_path(std::filesystem::canonical(path, ignored)));
  if (s.kind == file_kind::regular) {
    const std::uintmax_t size = std::filesystem::file_size(path, ignored);
    s.size = ignored ? 0 : static_cast<std::uint64_t>(size);
  }
  const auto written = std::filesystem::last_write_time(path, ignored).time_since_epoch();
  const auto whole = std::chrono::duration_cast<std::chrono::seconds>(written);
  s.seconds = static_cast<std::int64_t>(whole.count());
  s.nanoseconds =
      static_cast<std::int64_t>(std::chrono::duration_cast<std::chrono::nanoseconds>(written - whole).count());
  return s;
}

CONCINO_INLINE file_status status_of(const std::string& path) {
  std::error_code error;
  const std::filesystem::path p = system_path(path);
  return status_from(p, std::filesystem::status(p, error), error);
}

CONCINO_INLINE file_status status_of_link(const std::string& path) {
  std::error_code error;
  const std::filesystem::path p = system_path(path);
  return status_from(p, std::filesystem::symlink_status(p, error), error);
}

CONCINO_INLINE file_status status_of(file_handle, const std::string& path) { return status_of(path); }

CONCINO_INLINE file_handle open_to_read(const std::string& path) {
  const std::filesystem::path p = system_path(path);
  std::error_code error;
  if (std::filesystem::is_directory(p, error)) {  // which not every system opens
    errno = EISDIR;
    return no_file;
  }
  return open_stream(p, false);
}

CONCINO_INLINE bool wait_for_writer(file_handle) { return true; }

CONCINO_INLINE std::ptrdiff_t read_some(file_handle file, char* to, std::size_t n) {
  errno = 0;
  const std::size_t done = std::fread(to, 1, n, file);
  if (done > 0 || n == 0 || std::ferror(file) == 0) return static_cast<std::ptrdiff_t>(done);
  if (errno == 0) errno = EIO;
  return -1;
}

CONCINO_INLINE bool write_all(file_handle file, const char* from, std::size_t n) {
  errno = 0;
  if (std::fwrite(from, 1, n, file) == n) return true;
  if (errno == 0) errno = EIO;
  return false;
}

CONCINO_INLINE void close_file(file_handle file) noexcept { std::fclose(file); }

CONCINO_INLINE bool remove_file(const std::string& path) noexcept {
  try {
    std::error_code error;
    return std::filesystem::remove(system_path(path), error);
  } catch (...) {  // no memory for the path
    return false;
  }
}

CONCINO_INLINE const char* map_file(file_handle, std::size_t) {
  errno = ENOTSUP;
  return nullptr;
}

CONCINO_INLINE void unmap_file(const char*, std::size_t) noexcept {}

CONCINO_INLINE std::string with_slashes(const std::string& path) { return text_of_path(system_path(path)); }

CONCINO_INLINE std::string real_path(const std::string& path) {
  std::error_code error;
  const std::filesystem::path real = std::filesystem::canonical(system_path(path), error);
  return error ? std::string() : text_of_path(real);
}

CONCINO_INLINE std::string link_target(const std::string& path) {
  std::error_code error;
  const std::filesystem::path from = system_path(path);
  const std::filesystem::path to = std::filesystem::read_symlink(from, error);
  return error ? std::string() : text_of_path(from.parent_path() / to);
}

}  // namespace concino::detail

namespace concino {

CONCINO_INLINE void atomic_file::open() {
  const detail::file_status old = detail::status_of(folder_path_ + name_);
  if (old.kind == detail::file_kind::none && errno != ENOENT) fail();
  if (old.kind == detail::file_kind::folder) detail::throw_io_error(path_, "cannot be written", EISDIR);
  if (old.kind != detail::file_kind::none && old.kind != detail::file_kind::regular)
    core::throw_joined<io_error>({path_, ": is not a regular file"});
  const std::filesystem::path target = detail::system_path(folder_path_ + name_);
  std::error_code error;
  const std::filesystem::perms permissions = std::filesystem::status(target, error).permissions();
  const bool exists = old.kind == detail::file_kind::regular;
  if (exists && (permissions & std::filesystem::perms::owner_write) == std::filesystem::perms::none) {
    errno = EACCES;
    fail();
  }
  const std::string base = temporary_name(name_);
  old_name_ = core::joined({base, ".old"});
  for (std::uint64_t attempt = 0; file_ == detail::no_file; ++attempt) {
    std::string name = core::joined({base, "-", attempt});
    const std::filesystem::path path = detail::system_path(folder_path_ + name);
    if (std::filesystem::exists(path, error)) continue;
    file_ = detail::open_stream(path, true);
    if (file_ == detail::no_file) fail();
    temporary_.swap(name);
    // best effort: the new file is correct without it
    if (exists) std::filesystem::permissions(path, permissions, error);
  }
}

CONCINO_INLINE void atomic_file::close() noexcept {
  if (file_ != detail::no_file) std::fclose(std::exchange(file_, detail::no_file));
  try {
    if (!temporary_.empty()) detail::remove_file(folder_path_ + temporary_);
    if (has_old_) detail::remove_file(folder_path_ + old_name_);
  } catch (...) {  // no memory for the path: the file stays
  }
}

CONCINO_INLINE void atomic_file::finish() {
  if (std::exchange(finished_, true)) return;
  errno = 0;
  if (std::fclose(std::exchange(file_, detail::no_file)) == 0) return;  // Windows renames closed files only
  if (errno == 0) errno = EIO;
  fail();
}

CONCINO_INLINE void atomic_file::commit() {
  finish();
  const std::filesystem::path from = detail::system_path(folder_path_ + temporary_),
                              to = detail::system_path(folder_path_ + name_);
  std::error_code error, ignored;
  if (options_.must_be_new && std::filesystem::exists(to, error)) {
    errno = EEXIST;
    fail("cannot be created");
  }
  const std::filesystem::path old = detail::system_path(folder_path_ + old_name_);
  if (options_.keep_old && std::filesystem::is_regular_file(to, ignored)) {
    std::filesystem::rename(to, old, error);
    has_old_ = !error;
  }
  if (!error) std::filesystem::rename(from, to, error);
  if (error) {
    if (std::exchange(has_old_, false)) std::filesystem::rename(old, to, ignored);
    detail::set_errno(error);
    fail(options_.must_be_new ? "cannot be created" : "cannot be replaced");
  }
  temporary_.clear();
  committed_ = true;
}

CONCINO_INLINE void atomic_file::undo() {
  std::error_code ignored;
  if (std::exchange(has_old_, false))
    std::filesystem::rename(detail::system_path(folder_path_ + old_name_), detail::system_path(folder_path_ + name_),
                            ignored);
  else detail::remove_file(folder_path_ + name_);
}

}  // namespace concino

#endif
