// Atomic replacement of files on POSIX systems: definitions of the part of atomic_file.hpp that depends on the system.
#pragma once

#if defined(__unix__) || defined(__APPLE__)

#include <concino/core/message.hpp>
#include <concino/io/atomic_file.hpp>
#include <concino/io/detail/files/io_errors.hpp>
#include <concino/io/detail/files/system_files.hpp>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

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

  /// Gives an existing target a second name, or where the file system has no links, another name.
  static bool keep_old(atomic_file& f) {
    struct ::stat old;
    if (::fstatat(f.folder_, f.name_.c_str(), &old, 0) != 0 || !S_ISREG(old.st_mode)) return true;  // not replaced
    for (int tries = 0; tries < 100; ++tries) {
      f.has_old_ = ::linkat(f.folder_, f.name_.c_str(), f.folder_, f.old_name_.c_str(), 0) == 0;
      if (f.has_old_ || errno == ENOENT) return true;
      if (errno != EEXIST) break;
      ::unlinkat(f.folder_, f.old_name_.c_str(), 0);  // of a process that was killed
    }
    f.has_old_ = ::renameat(f.folder_, f.name_.c_str(), f.folder_, f.old_name_.c_str()) == 0;
    return f.has_old_;
  }

  /// Gives the old target its name again. If it has both, nothing changes.
  static void put_back(const atomic_file& f) {
    ::renameat(f.folder_, f.old_name_.c_str(), f.folder_, f.name_.c_str());
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
  old_name_ = core::joined({base, ".old"});
  if (!system::open_unnamed(*this)) system::open_named(*this, base);
  if (exists) (void)!::fchmod(file_, old.st_mode & 07777);  // best effort: the new file is correct without it
}

CONCINO_INLINE void atomic_file::close() noexcept {
  if (file_ != detail::no_file) ::close(std::exchange(file_, detail::no_file));
  if (folder_ >= 0 && !temporary_.empty()) ::unlinkat(folder_, temporary_.c_str(), 0);
  if (folder_ >= 0 && has_old_) ::unlinkat(folder_, old_name_.c_str(), 0);
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
  if (options_.keep_old && !system::keep_old(*this)) fail("cannot be replaced");
  if (temporary_.empty() ? !system::commit_unnamed(*this) : !system::commit_named(*this)) {
    const int why = errno;
    if (has_old_) system::put_back(*this);
    errno = why;
    fail(options_.must_be_new ? "cannot be created" : "cannot be replaced");
  }
  committed_ = true;
  if (options_.sync && ::fsync(folder_) != 0 && errno != EINVAL)
    fail("is written, but its folder cannot be synchronised to disk");
}

CONCINO_INLINE void atomic_file::undo() {
  if (std::exchange(has_old_, false)) system::put_back(*this);
  else ::unlinkat(folder_, name_.c_str(), 0);
}

}  // namespace concino

#endif
