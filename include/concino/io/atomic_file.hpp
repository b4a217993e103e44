// Atomic replacement of a file: it gets its name only when it is complete (POSIX; on Linux, unfinished files leave no trace).
#pragma once

#include <concino/core/compiled.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace concino {

/// Options of atomic_file.
struct atomic_file_options {
  bool sync = false;         // the file reaches the disk before it gets its name, and the name before commit() returns
  bool must_be_new = false;  // if the target exists, it is kept and commit() fails
  bool unnamed = true;       // the unfinished file has no name, if the system supports that, so that it disappears with the process
};

/// A new file in the folder of the target, which replaces the target on commit(). Unless commit() succeeds, the target stays as it was and
/// the new file is removed. A symbolic link is kept: the file that it refers to is replaced or created.
/// If the system has no unnamed files, a process that is killed leaves a file .concino-... . The next process that writes to the same target
/// removes it.
class atomic_file {
  std::string path_;       // for messages
  std::string name_;       // the name of the target in its folder
  std::string temporary_;  // the name of the unfinished file in this folder; empty: unnamed
  std::string link_name_;  // the name of an unnamed file after it is linked and before it is renamed
  atomic_file_options options_;
  int folder_ = -1, file_ = -1;
  bool finished_ = false, committed_ = false;

  [[noreturn, gnu::cold]] void fail(const char* what = "cannot be written") const;

  static constexpr std::size_t proc_size = 32;
  static void name_in_proc(int file, char (&name)[proc_size]);

  void close_all();

  bool open_unnamed();

  /// Opens a file with a temporary name, and locks it. An existing file without a lock belongs to a process that was killed, and is removed.
  void open_named(const std::string& base);

  bool link_unnamed(const std::string& name);

 public:
  /// The prefix of the names of unfinished files for that target: short, and the same each time.
  static std::string temporary_name(std::string_view target);

  /// Errors: io_error if no file can be created there, if the target exists and is not a file, or if the path contains a character of value 0.
  explicit atomic_file(const std::string& path, const atomic_file_options& options = {});
  atomic_file(const atomic_file&) = delete;
  atomic_file& operator=(const atomic_file&) = delete;
  ~atomic_file();

  /// The descriptor of the new file, to write to.
  int descriptor() const { return file_; }

  /// Does everything that must precede the naming of the file, so that little can fail in commit(). Nothing may be written afterwards.
  void finish();

  /// Replaces the target with the new file. Allocates no memory if finish() was called.
  /// Errors: io_error. The target is then as it was, unless the only failure was to synchronise its folder with the disk.
  void commit();

  /// Whether the file has its name.
  bool is_committed() const { return committed_; }

  /// Removes the file that commit() has put in place.
  void undo();

 private:
  bool commit_unnamed();

  bool commit_named();
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/io/detail/files/atomic_file.ipp>
#endif
