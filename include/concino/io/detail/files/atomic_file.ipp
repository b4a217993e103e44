// Definitions of atomic_file.hpp.
#pragma once

#include <concino/core/hash_bytes.hpp>
#include <concino/core/message.hpp>
#include <concino/io/atomic_file.hpp>
#include <concino/io/detail/files/io_errors.hpp>
#include <concino/io/detail/files/paths.hpp>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace concino {

[[noreturn, gnu::noinline, gnu::cold]] CONCINO_INLINE void atomic_file::fail(const char* what) const { detail::throw_io_error(path_, what, errno); }

CONCINO_INLINE void atomic_file::name_in_proc(int file, char (&name)[proc_size]) { std::snprintf(name, proc_size, "/proc/self/fd/%d", file); }

CONCINO_INLINE void atomic_file::close_all() {
  if (file_ >= 0) ::close(std::exchange(file_, -1));
  if (folder_ >= 0 && !temporary_.empty()) ::unlinkat(folder_, temporary_.c_str(), 0);
  if (folder_ >= 0) ::close(std::exchange(folder_, -1));
}

CONCINO_INLINE bool atomic_file::open_unnamed() {
#ifdef O_TMPFILE
  if (!options_.unnamed) return false;
  file_ = ::openat(folder_, ".", O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
  if (file_ < 0) return false;
  char source[proc_size];
  name_in_proc(file_, source);
  if (::access(source, F_OK) == 0) return true;  // otherwise the file cannot get a name
  ::close(std::exchange(file_, -1));
#endif
  return false;
}

CONCINO_INLINE void atomic_file::open_named(const std::string& base) {
  for (std::uint64_t attempt = 0; attempt < 10000; ++attempt) {
    std::string name = core::joined({base, "-", attempt});
    for (int tries = 0; tries < 2; ++tries) {
      const int opened = ::openat(folder_, name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (opened < 0 && errno != EEXIST) fail();
      if (opened >= 0) {
        if (::flock(opened, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) {
          file_ = opened;
          temporary_.swap(name);
          return;
        }
        ::close(opened);  // another process has locked it and will remove it as abandoned
        break;
      }
      const int found = ::openat(folder_, name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
      if (found < 0) break;
      struct ::stat locked {};
      struct ::stat there {};
      const bool abandoned = ::flock(found, LOCK_EX | LOCK_NB) == 0 && ::fstat(found, &locked) == 0 &&
                             ::fstatat(folder_, name.c_str(), &there, AT_SYMLINK_NOFOLLOW) == 0 && locked.st_ino == there.st_ino &&
                             locked.st_dev == there.st_dev && ::unlinkat(folder_, name.c_str(), 0) == 0;
      ::close(found);
      if (!abandoned) break;
    }
  }
  errno = EEXIST;
  fail();
}

CONCINO_INLINE bool atomic_file::link_unnamed(const std::string& name) {
  char source[proc_size];
  name_in_proc(file_, source);
  return ::linkat(AT_FDCWD, source, folder_, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

CONCINO_INLINE std::string atomic_file::temporary_name(std::string_view target) { return core::joined({".concino-", core::hash_text(target)}); }

CONCINO_INLINE atomic_file::atomic_file(const std::string& path, const atomic_file_options& options)
    : path_(path), options_(options) {
  detail::check_path(path);
  const std::string target = detail::resolve_links(path);
  const std::size_t slash = target.rfind('/') + 1;
  name_ = target.substr(slash);
  const std::string folder = slash == 0 ? std::string(".") : target.substr(0, slash);
  const std::string base = temporary_name(name_);
  link_name_ = core::joined({base, ".link"});
  if (name_.empty()) detail::throw_io_error(path_, "cannot be written", target.empty() ? ENOENT : EISDIR);
  folder_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
#ifdef O_PATH
  if (folder_ < 0 && errno == EACCES && !options_.sync) folder_ = ::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
#endif
  if (folder_ < 0) fail();
  try {
    struct ::stat old {};
    const bool exists = ::fstatat(folder_, name_.c_str(), &old, 0) == 0;
    if (!exists && errno != ENOENT) fail();
    if (exists && S_ISDIR(old.st_mode)) detail::throw_io_error(path_, "cannot be written", EISDIR);
    if (exists && !S_ISREG(old.st_mode)) core::throw_joined<io_error>({path_, ": is not a regular file"});
    if (exists && ::faccessat(folder_, name_.c_str(), W_OK, 0) != 0) fail();
    if (!open_unnamed()) open_named(base);
    if (exists) (void)!::fchmod(file_, old.st_mode & 07777);  // best effort: the new file is correct without it
  } catch (...) {
    close_all();
    throw;
  }
}

CONCINO_INLINE atomic_file::~atomic_file() { close_all(); }

CONCINO_INLINE void atomic_file::finish() {
  if (std::exchange(finished_, true)) return;
  if (options_.sync && ::fsync(file_) != 0) fail();
  const int duplicate = ::dup(file_);  // some file systems report errors when a file is closed, and file_ has to stay open
  if (duplicate < 0 || ::close(duplicate) != 0) fail();
}

CONCINO_INLINE void atomic_file::commit() {
  finish();
  if (temporary_.empty() ? !commit_unnamed() : !commit_named()) fail(options_.must_be_new ? "cannot be created" : "cannot be replaced");
  committed_ = true;
  if (options_.sync && ::fsync(folder_) != 0 && errno != EINVAL) fail("is written, but its folder cannot be synchronised to disk");
}

CONCINO_INLINE void atomic_file::undo() { ::unlinkat(folder_, name_.c_str(), 0); }

CONCINO_INLINE bool atomic_file::commit_unnamed() {
  if (link_unnamed(name_)) return true;
  // Only renaming can replace an existing file.
  for (int tries = 0; errno == EEXIST && !options_.must_be_new && tries < 100; ++tries) {
    if (!link_unnamed(link_name_)) {
      if (errno == EEXIST && ::unlinkat(folder_, link_name_.c_str(), 0) != 0 && errno != ENOENT) return false;
      errno = EEXIST;
      continue;
    }
    if (::renameat(folder_, link_name_.c_str(), folder_, name_.c_str()) == 0) return true;
    const int why = errno;
    ::unlinkat(folder_, link_name_.c_str(), 0);
    errno = why == ENOENT ? EEXIST : why;  // another process has removed the link: try again
  }
  return false;
}

CONCINO_INLINE bool atomic_file::commit_named() {
  if (options_.must_be_new) return ::linkat(folder_, temporary_.c_str(), folder_, name_.c_str(), 0) == 0;
  if (::renameat(folder_, temporary_.c_str(), folder_, name_.c_str()) != 0) return false;
  temporary_.clear();
  return true;
}

}  // namespace concino
