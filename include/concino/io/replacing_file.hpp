// A file appears under its name only when it is complete (POSIX; without a trace of unfinished ones on Linux).
#pragma once

#include <concino/core/hash_bytes.hpp>
#include <concino/io/detail/paths.hpp>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace concino {

/// How replacing_file writes.
struct replacing_options {
  bool sync = false;         // the file reaches the disk before it gets its name, and the name before commit() returns
  bool must_be_new = false;  // a file that is there stays, and commit() fails
  bool unnamed = true;       // the unfinished file has no name where the system can do that, so that it goes with the process
};

/// A new file in the folder of the target, which takes its place by commit(). Unless that succeeds the target stays as it was and the new
/// file goes. A link stays a link: the file that it names is replaced or made.
/// Where the system has no unnamed files a process that is killed leaves a file .concino-..., which the next that writes to the same target
/// removes.
class replacing_file {
  std::string path_;       // for messages
  std::string name_;       // of the target in its folder
  std::string temporary_;  // the name of the unfinished file in this folder; empty: it has none
  std::string link_name_;  // the name that an unnamed file has between being linked and being renamed
  replacing_options options_;
  int folder_ = -1, file_ = -1;
  bool finished_ = false, committed_ = false;

  [[noreturn, gnu::noinline, gnu::cold]] void fail(const char* what = "cannot be written") const { detail::throw_io_error(path_, what, errno); }

  static constexpr std::size_t proc_size = 32;
  static void name_in_proc(int file, char (&name)[proc_size]) { std::snprintf(name, proc_size, "/proc/self/fd/%d", file); }

  void close_all() {
    if (file_ >= 0) ::close(std::exchange(file_, -1));
    if (folder_ >= 0 && !temporary_.empty()) ::unlinkat(folder_, temporary_.c_str(), 0);
    if (folder_ >= 0) ::close(std::exchange(folder_, -1));
  }

  bool open_unnamed() {
#ifdef O_TMPFILE
    if (!options_.unnamed) return false;
    file_ = ::openat(folder_, ".", O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
    if (file_ < 0) return false;
    char source[proc_size];
    name_in_proc(file_, source);
    if (::access(source, F_OK) == 0) return true;  // else there is no way to give it a name
    ::close(std::exchange(file_, -1));
#endif
    return false;
  }

  /// A lock tells unfinished files from those of processes that were killed; these are removed.
  void open_named(const std::string& base) {
    for (std::uint64_t attempt = 0; attempt < 10000; ++attempt) {
      std::string name = core::joined({base, "-", attempt});
      for (int tries = 0; tries < 2; ++tries) {
        const int made = ::openat(folder_, name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (made < 0 && errno != EEXIST) fail();
        if (made >= 0) {
          if (::flock(made, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) {
            file_ = made;
            temporary_.swap(name);
            return;
          }
          ::close(made);  // another has taken it for abandoned
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

  bool link_unnamed(const std::string& name) {
    char source[proc_size];
    name_in_proc(file_, source);
    return ::linkat(AT_FDCWD, source, folder_, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
  }

 public:
  /// The beginning of the names that unfinished files for that target may have: short, and the same each time.
  static std::string temporary_name(std::string_view target) { return core::joined({".concino-", core::hash_text(target)}); }

  /// Errors: io_error if no file can be made there, what is there is not a file, or the path holds a character of value 0.
  [[gnu::noinline, gnu::cold]] explicit replacing_file(const std::string& path, const replacing_options& options = {})
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
      if (exists && !S_ISREG(old.st_mode)) core::throw_joined<io_error>({path_, ": is not a file"});
      if (exists && ::faccessat(folder_, name_.c_str(), W_OK, 0) != 0) fail();
      if (!open_unnamed()) open_named(base);
      if (exists) (void)!::fchmod(file_, old.st_mode & 07777);  // best effort: the new file is right without it
    } catch (...) {
      close_all();
      throw;
    }
  }
  replacing_file(const replacing_file&) = delete;
  replacing_file& operator=(const replacing_file&) = delete;
  [[gnu::noinline, gnu::cold]] ~replacing_file() { close_all(); }

  /// Of the new file, to write to.
  int descriptor() const { return file_; }

  /// All that is left to do before the file gets its name, so that little can fail afterwards. Nothing is written any more.
  [[gnu::noinline, gnu::cold]] void finish() {
    if (std::exchange(finished_, true)) return;
    if (options_.sync && ::fsync(file_) != 0) fail();
    const int twin = ::dup(file_);  // some file systems tell of errors when a file is closed; this one has to stay open
    if (twin < 0 || ::close(twin) != 0) fail();
  }

  /// No memory is needed once the file is finished.
  /// Errors: io_error; the target is as it was, unless only its folder could not be brought to the disk.
  [[gnu::noinline, gnu::cold]] void commit() {
    finish();
    if (temporary_.empty() ? !commit_unnamed() : !commit_named()) fail(options_.must_be_new ? "cannot be made" : "cannot be replaced");
    committed_ = true;
    if (options_.sync && ::fsync(folder_) != 0 && errno != EINVAL) fail("is written, but its folder cannot be brought to the disk");
  }

  /// Whether the file has its name.
  bool is_committed() const { return committed_; }

  /// Takes the file away that commit() has put there.
  void undo() { ::unlinkat(folder_, name_.c_str(), 0); }

 private:
  bool commit_unnamed() {
    if (link_unnamed(name_)) return true;
    // A name that is taken can be replaced by renaming only.
    for (int tries = 0; errno == EEXIST && !options_.must_be_new && tries < 100; ++tries) {
      if (!link_unnamed(link_name_)) {
        if (errno == EEXIST && ::unlinkat(folder_, link_name_.c_str(), 0) != 0 && errno != ENOENT) return false;
        errno = EEXIST;
        continue;
      }
      if (::renameat(folder_, link_name_.c_str(), folder_, name_.c_str()) == 0) return true;
      const int why = errno;
      ::unlinkat(folder_, link_name_.c_str(), 0);
      errno = why == ENOENT ? EEXIST : why;  // another process has taken the name away: again
    }
    return false;
  }

  bool commit_named() {
    if (options_.must_be_new) return ::linkat(folder_, temporary_.c_str(), folder_, name_.c_str(), 0) == 0;
    if (::renameat(folder_, temporary_.c_str(), folder_, name_.c_str()) != 0) return false;
    temporary_.clear();
    return true;
  }
};

}  // namespace concino
