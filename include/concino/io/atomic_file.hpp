// A file appears under its name only when it is complete (POSIX; without a trace of unfinished ones on Linux).
#pragma once

#include <concino/core/compiled.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace concino {

/// How atomic_file writes.
struct atomic_file_options {
  bool sync = false;         // the file reaches the disk before it gets its name, and the name before commit() returns
  bool must_be_new = false;  // a file that is there stays, and commit() fails
  bool unnamed = true;       // the unfinished file has no name where the system can do that, so that it goes with the process
};

/// A new file in the folder of the target, which takes its place by commit(). Unless that succeeds the target stays as it was and the new
/// file goes. A link stays a link: the file that it names is replaced or made.
/// Where the system has no unnamed files a process that is killed leaves a file .concino-..., which the next that writes to the same target
/// removes.
class atomic_file {
  std::string path_;       // for messages
  std::string name_;       // of the target in its folder
  std::string temporary_;  // the name of the unfinished file in this folder; empty: it has none
  std::string link_name_;  // the name that an unnamed file has between being linked and being renamed
  atomic_file_options options_;
  int folder_ = -1, file_ = -1;
  bool finished_ = false, committed_ = false;

  [[noreturn, gnu::cold]] void fail(const char* what = "cannot be written") const;

  static constexpr std::size_t proc_size = 32;
  static void name_in_proc(int file, char (&name)[proc_size]);

  void close_all();

  bool open_unnamed();

  /// A lock tells unfinished files from those of processes that were killed; these are removed.
  void open_named(const std::string& base);

  bool link_unnamed(const std::string& name);

 public:
  /// The beginning of the names that unfinished files for that target may have: short, and the same each time.
  static std::string temporary_name(std::string_view target);

  /// Errors: io_error if no file can be made there, what is there is not a file, or the path holds a character of value 0.
  explicit atomic_file(const std::string& path, const atomic_file_options& options = {});
  atomic_file(const atomic_file&) = delete;
  atomic_file& operator=(const atomic_file&) = delete;
  ~atomic_file();

  /// Of the new file, to write to.
  int descriptor() const { return file_; }

  /// All that is left to do before the file gets its name, so that little can fail afterwards. Nothing is written any more.
  void finish();

  /// No memory is needed once the file is finished.
  /// Errors: io_error; the target is as it was, unless only its folder could not be brought to the disk.
  void commit();

  /// Whether the file has its name.
  bool is_committed() const { return committed_; }

  /// Takes the file away that commit() has put there.
  void undo();

 private:
  bool commit_unnamed();

  bool commit_named();
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/io/detail/atomic_file.ipp>
#endif
