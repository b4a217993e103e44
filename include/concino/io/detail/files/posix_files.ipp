// Files on POSIX systems: definitions of system_files.hpp, and of the part of atomic_file.hpp that depends on the
// system. The only file of this module that includes headers of POSIX.
#pragma once

#if defined(__unix__) || defined(__APPLE__)

#include <concino/core/message.hpp>
#include <concino/io/atomic_file.hpp>
#include <concino/io/detail/files/io_errors.hpp>
#include <concino/io/detail/files/system_files.hpp>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
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

namespace concino {

/// The steps of an atomic_file. The unfinished file has no name if the system supports that, or else a temporary name
/// and a lock.
struct atomic_file::system {
  static constexpr std::size_t proc_size = 32;
  static void name_in_proc(int file, char (&name)[proc_size]) {
    std::snprintf(name, proc_size, "/proc/self/fd/%d", file);
  }

  static void open_folder(atomic_file& f, const std::string& folder) {
    f.folder_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
#ifdef O_PATH
    if (f.folder_ < 0 && errno == EACCES && !f.options_.sync)
      f.folder_ = ::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
#endif
    if (f.folder_ < 0) f.fail();
  }

  static bool open_unnamed([[maybe_unused]] atomic_file& f) {
#ifdef O_TMPFILE
    if (!f.options_.unnamed) return false;
    f.file_ = ::openat(f.folder_, ".", O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
    if (f.file_ < 0) return false;
    char source[proc_size];
    name_in_proc(f.file_, source);
    if (::access(source, F_OK) == 0) return true;  // otherwise the file cannot get a name
    ::close(std::exchange(f.file_, -1));
#endif
    return false;
  }

  /// Removes a file that belongs to a process that was killed: it has no lock.      Result: whether it was one.
  static bool remove_abandoned(int folder, const char* name) {
    const int found = ::openat(folder, name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (found < 0) return false;
    struct ::stat locked {};
    struct ::stat there {};
    const bool abandoned = ::flock(found, LOCK_EX | LOCK_NB) == 0 && ::fstat(found, &locked) == 0 &&
                           ::fstatat(folder, name, &there, AT_SYMLINK_NOFOLLOW) == 0 && locked.st_ino == there.st_ino &&
                           locked.st_dev == there.st_dev && ::unlinkat(folder, name, 0) == 0;
    ::close(found);
    return abandoned;
  }

  /// Opens a file with a temporary name, and locks it.
  static void open_named(atomic_file& f, const std::string& base) {
    for (std::uint64_t attempt = 0; attempt < 10000; ++attempt) {
      std::string name = core::joined({base, "-", attempt});
      for (int tries = 0; tries < 2; ++tries) {
        const int opened = ::openat(f.folder_, name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (opened < 0 && errno != EEXIST) f.fail();
        if (opened < 0) {
          if (remove_abandoned(f.folder_, name.c_str())) continue;
          break;
        }
        if (::flock(opened, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) {
          f.file_ = opened;
          f.temporary_.swap(name);
          return;
        }
        ::close(opened);  // another process has locked it and will remove it as abandoned
        break;
      }
    }
    errno = EEXIST;
    f.fail();
  }

  static bool link_unnamed(const atomic_file& f, const std::string& name) {
    char source[proc_size];
    name_in_proc(f.file_, source);
    return ::linkat(AT_FDCWD, source, f.folder_, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
  }

  static bool commit_unnamed(const atomic_file& f) {
    if (link_unnamed(f, f.name_)) return true;
    // Only renaming can replace an existing file.
    for (int tries = 0; errno == EEXIST && !f.options_.must_be_new && tries < 100; ++tries) {
      if (!link_unnamed(f, f.link_name_)) {
        if (errno == EEXIST && ::unlinkat(f.folder_, f.link_name_.c_str(), 0) != 0 && errno != ENOENT) return false;
        errno = EEXIST;
        continue;
      }
      if (::renameat(f.folder_, f.link_name_.c_str(), f.folder_, f.name_.c_str()) == 0) return true;
      const int why = errno;
      ::unlinkat(f.folder_, f.link_name_.c_str(), 0);
      errno = why == ENOENT ? EEXIST : why;  // another process has removed the link: try again
    }
    return false;
  }

  static bool commit_named(atomic_file& f) {
    if (f.options_.must_be_new) return ::linkat(f.folder_, f.temporary_.c_str(), f.folder_, f.name_.c_str(), 0) == 0;
    if (::renameat(f.folder_, f.temporary_.c_str(), f.folder_, f.name_.c_str()) != 0) return false;
    f.temporary_.clear();
    return true;
  }
};

CONCINO_INLINE void atomic_file::open() {
  system::open_folder(*this, folder_path_.empty() ? std::string(".") : folder_path_);
  struct ::stat old {};
  const bool exists = ::fstatat(folder_, name_.c_str(), &old, 0) == 0;
  if (!exists && errno != ENOENT) fail();
  if (exists && S_ISDIR(old.st_mode)) detail::throw_io_error(path_, "cannot be written", EISDIR);
  if (exists && !S_ISREG(old.st_mode)) core::throw_joined<io_error>({path_, ": is not a regular file"});
  if (exists && ::faccessat(folder_, name_.c_str(), W_OK, 0) != 0) fail();
  const std::string base = temporary_name(name_);
  link_name_ = core::joined({base, ".link"});
  if (!system::open_unnamed(*this)) system::open_named(*this, base);
  if (exists) (void)!::fchmod(file_, old.st_mode & 07777);  // best effort: the new file is correct without it
}

CONCINO_INLINE void atomic_file::close() noexcept {
  if (file_ != detail::no_file) ::close(std::exchange(file_, detail::no_file));
  if (folder_ >= 0 && !temporary_.empty()) ::unlinkat(folder_, temporary_.c_str(), 0);
  if (folder_ >= 0) ::close(std::exchange(folder_, -1));
}

CONCINO_INLINE void atomic_file::finish() {
  if (std::exchange(finished_, true)) return;
  if (options_.sync && ::fsync(file_) != 0) fail();
  const int duplicate = ::dup(file_);  // some file systems report errors when a file is closed, and file_ has to stay
                                       // open
  if (duplicate < 0 || ::close(duplicate) != 0) fail();
}

CONCINO_INLINE void atomic_file::commit() {
  finish();
  if (temporary_.empty() ? !system::commit_unnamed(*this) : !system::commit_named(*this))
    fail(options_.must_be_new ? "cannot be created" : "cannot be replaced");
  committed_ = true;
  if (options_.sync && ::fsync(folder_) != 0 && errno != EINVAL)
    fail("is written, but its folder cannot be synchronised to disk");
}

CONCINO_INLINE void atomic_file::undo() { ::unlinkat(folder_, name_.c_str(), 0); }

}  // namespace concino

#endif
