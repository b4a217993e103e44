// The files of a mesh that is a folder, which replace those of the same names together.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/atomic_file.hpp>
#include <concino/io/text_sink.hpp>
#include <concino/io/write_context.hpp>

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace concino::detail {

/// New files in a folder, which is created if it does not exist, with all that lead to it. Unless commit() succeeds,
/// the folder stays as it was. Files get their names one after another, so that a process that is killed meanwhile
/// leaves some old and some new ones. If commit() fails after the first, it puts back the old files.
class folder_files final : public folder_sink {
  struct part {
    atomic_file file;
    text_sink out;

    part(const std::string& path, bool sync)
        : file(path, {.sync = sync, .keep_old = true}), out(file.descriptor(), path) {}
  };
  std::string folder_;  // with a slash
  bool sync_, is_committed_ = false;
  std::vector<std::string> created_;  // folders, the innermost first
  std::vector<std::unique_ptr<part>> parts_;
  std::vector<std::string> removed_, removed_backups_;  // paths
  std::size_t num_removed_ = 0;
  std::vector<std::string> stale_;                      // what processes that were killed may have left

  void put_back() noexcept;

 public:
  /// Errors: io_error if there is no folder and none can be created.
  folder_files(const std::string& path, bool sync);
  folder_files(const folder_files&) = delete;
  folder_files& operator=(const folder_files&) = delete;
  ~folder_files() override;

  /// Errors: io_error, as atomic_file.
  text_sink& file(std::string_view name) override;
  bool remove(std::string_view name) override;

  /// Does everything that must precede the naming of the files. Nothing may be written afterwards.
  void finish();
  /// Errors: io_error. The folder is then as it was.
  void commit();
};

/// A folder that keeps nothing.
class folder_nowhere final : public folder_sink {
  text_sink out_ = text_sink::nowhere();

 public:
  text_sink& file(std::string_view) override { return out_; }
  bool remove(std::string_view) override { return false; }
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/io/detail/files/folder_files.ipp>
#endif
