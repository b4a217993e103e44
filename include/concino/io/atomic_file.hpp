// Atomic replacement of a file: it gets its name only when it is complete. On Linux, unfinished files leave no trace.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/detail/files/file_handle.hpp>

#include <string>
#include <string_view>

namespace concino {

/// Options of atomic_file.
struct atomic_file_options {
  bool sync = false;         // the file reaches the disk before it gets its name, and the name before commit() returns
  bool must_be_new = false;  // if the target exists, it is kept and commit() fails
  bool unnamed = true;       // the unfinished file has no name, if the system supports that, so that it disappears with
                             // the process
  bool keep_old = false;     // the file that commit() replaces keeps another name until this object is destroyed, so
                             // that undo() can put it back
};

/// A new file in the folder of the target, which replaces the target on commit(). Unless commit() succeeds, the target
/// stays as it was and the new file is removed. A symbolic link is kept: the file that it refers to is replaced or
/// created. If the system has no unnamed files, a process that is killed leaves a file .concino-... . The next process
/// that writes to the same target removes it.
/// Where the system is not POSIX, the file has a name from the beginning: what a killed process leaves stays there.
/// `sync` has no effect. Two processes must not write the same file, or create the same new file, at the same time.
/// Paths are UTF-8 on Windows.
class atomic_file {
  std::string path_;         // for messages
  std::string folder_path_;  // the folder of the target, with a slash, or empty
  std::string name_;         // the name of the target in this folder
  std::string temporary_;    // the name of the unfinished file in this folder; empty: unnamed
  std::string link_name_;    // the name of an unnamed file after it is linked and before it is renamed
  std::string old_name_;     // the name of the file that commit() has replaced, with options_.keep_old
  atomic_file_options options_;
  int folder_ = -1;  // POSIX: the descriptor of the folder
  detail::file_handle file_ = detail::no_file;
  bool finished_ = false, committed_ = false, has_old_ = false;

  struct system;  // what only one kind of system needs

  [[noreturn, gnu::cold]] void fail(const char* what = "cannot be written") const;
  void open();
  void close() noexcept;

 public:
  /// The prefix of the names of unfinished files for that target: short, and the same each time.
  static std::string temporary_name(std::string_view target);

  /// Errors: io_error if no file can be created there, if the target exists and is not a file, or if the path contains
  ///         a character of value 0.
  explicit atomic_file(const std::string& path, const atomic_file_options& options = {});
  atomic_file(const atomic_file&) = delete;
  atomic_file& operator=(const atomic_file&) = delete;
  ~atomic_file();

  /// The new file, to write to: a descriptor (int) on POSIX systems, a std::FILE* on others.
  detail::file_handle descriptor() const { return file_; }

  /// Does everything that must precede the naming of the file, so that little can fail in commit(). Nothing may be
  /// written afterwards.
  void finish();

  /// Replaces the target with the new file. On POSIX systems it allocates no memory if finish() was called.
  /// Errors: io_error. The target is then as it was, unless the only failure was to synchronise its folder with the
  ///         disk.
  void commit();

  /// Whether the file has its name.
  bool is_committed() const { return committed_; }

  /// Removes the file that commit() has put in place. With options.keep_old, puts back the one that it has replaced.
  void undo();
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/io/detail/files/atomic_file.ipp>
#endif
