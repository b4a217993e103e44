// The files that are written beside a .ele or .node file: all get their names, or none.
#pragma once

#include <concino/io/atomic_file.hpp>
#include <concino/io/text_sink.hpp>
#include <concino/io/write_context.hpp>

#include <memory>
#include <string>
#include <vector>

namespace concino::detail {

class tetgen_files final : public companion_files {
  std::vector<std::unique_ptr<atomic_file>> files_;

 public:
  /// Writes a file: f(out). It gets its name in commit_with().      Errors: io_error, and those of f.
  template<class F>
  void write(const std::string& path, bool sync, const F& f) {
    atomic_file& file =
        *files_.emplace_back(std::make_unique<atomic_file>(path, atomic_file_options{.sync = sync, .keep_old = true}));
    text_sink out(file.descriptor(), path);
    f(out);
    out.flush();
    file.finish();
  }

  /// Errors: io_error. The files that were replaced are put back then, unless the only failure was to synchronise the
  ///         folder of the last one with the disk.
  void commit_with(atomic_file& last) override {
    try {
      for (const auto& file : files_) file->commit();
      last.commit();
    } catch (...) {
      for (std::size_t i = files_.size(); i-- > 0 && !last.is_committed();)
        if (files_[i]->is_committed()) files_[i]->undo();
      throw;
    }
  }
};

}  // namespace concino::detail
