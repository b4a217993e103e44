// Files on POSIX systems: definitions of system_files.hpp. Only this file and posix_atomic_file.ipp of this module
// include headers of POSIX.
#pragma once

#if defined(__unix__) || defined(__APPLE__)

#include <concino/core/message.hpp>
#include <concino/io/detail/files/system_files.hpp>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace concino::detail {

inline file_status status_from(const struct ::stat& info) {
  const ::mode_t mode = info.st_mode;
  file_status s;
  s.kind = S_ISREG(mode)    ? file_kind::regular
           : S_ISDIR(mode)  ? file_kind::folder
           : S_ISFIFO(mode) ? file_kind::pipe
                            : file_kind::other;
  s.size = static_cast<std::uint64_t>(info.st_size);
  s.device = static_cast<std::uint64_t>(info.st_dev);
  s.number = static_cast<std::uint64_t>(info.st_ino);
#ifdef __APPLE__
  const ::timespec& time = info.st_mtimespec;
#else
  const ::timespec& time = info.st_mtim;
#endif
  s.seconds = static_cast<std::int64_t>(time.tv_sec);
  s.nanoseconds = static_cast<std::int64_t>(time.tv_nsec);
  return s;
}

CONCINO_INLINE file_status status_of(const std::string& path) {
  struct ::stat info {};
  return ::stat(path.c_str(), &info) == 0 ? status_from(info) : file_status();
}

CONCINO_INLINE file_status status_of_link(const std::string& path) {
  struct ::stat info {};
  return ::lstat(path.c_str(), &info) == 0 ? status_from(info) : file_status();
}

CONCINO_INLINE file_status status_of(file_handle file, const std::string&) {
  struct ::stat info {};
  return ::fstat(file, &info) == 0 ? status_from(info) : file_status();
}

CONCINO_INLINE file_handle open_to_read(const std::string& path) {
  return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
}

CONCINO_INLINE bool wait_for_writer(file_handle file) { return ::fcntl(file, F_SETFL, O_RDONLY) == 0; }

CONCINO_INLINE std::ptrdiff_t read_some(file_handle file, char* to, std::size_t n) {
  for (;;)
    if (const ::ssize_t done = ::read(file, to, std::min<std::size_t>(n, 1 << 30)); done >= 0 || errno != EINTR)
      return done;
}

CONCINO_INLINE bool write_all(file_handle file, const char* from, std::size_t n) {
  while (n > 0) {
    const ::ssize_t done = ::write(file, from, n);
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) return false;
    from += done;
    n -= static_cast<std::size_t>(done);
  }
  return true;
}

CONCINO_INLINE void close_file(file_handle file) noexcept { ::close(file); }

CONCINO_INLINE bool remove_file(const std::string& path) noexcept { return ::unlink(path.c_str()) == 0; }

CONCINO_INLINE bool rename_file(const std::string& path, const std::string& new_path) noexcept {
  return std::rename(path.c_str(), new_path.c_str()) == 0;
}

CONCINO_INLINE bool create_folder(const std::string& path) { return ::mkdir(path.c_str(), 0777) == 0; }

CONCINO_INLINE bool remove_folder(const std::string& path) noexcept { return ::rmdir(path.c_str()) == 0; }

CONCINO_INLINE const char* map_file(file_handle file, std::size_t n) {
  void* const p = ::mmap(nullptr, n, PROT_READ, MAP_PRIVATE, file, 0);
  return p == MAP_FAILED ? nullptr : static_cast<const char*>(p);
}

CONCINO_INLINE void unmap_file(const char* bytes, std::size_t n) noexcept { ::munmap(const_cast<char*>(bytes), n); }

CONCINO_INLINE std::string with_slashes(const std::string& path) { return path; }

CONCINO_INLINE std::string real_path(const std::string& path) {
  char buffer[PATH_MAX + 1];
  return ::realpath(path.c_str(), buffer) ? std::string(buffer) : std::string();
}

CONCINO_INLINE std::string link_target(const std::string& path) {
  char buffer[PATH_MAX + 1];
  const ::ssize_t size = ::readlink(path.c_str(), buffer, PATH_MAX);
  if (size < 0) return {};
  const std::string_view to(buffer, static_cast<std::size_t>(size));
  return core::joined({std::string_view(path).substr(0, to.starts_with('/') ? 0 : path.rfind('/') + 1), to});
}

}  // namespace concino::detail

#endif
