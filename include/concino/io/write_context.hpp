// The input and output of writers, except the mesh: options, output, report.
#pragma once

#include <concino/core/message.hpp>
#include <concino/io/options.hpp>
#include <concino/io/text_sink.hpp>
#include <concino/mesh/property_set.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <typeinfo>
#include <vector>

namespace concino {

class atomic_file;

/// Additional files that are written with a file, such as a material library.
struct companion_files {
  virtual ~companion_files() = default;
  /// Gives these files and `file` their names, all or none. Calls file.commit().
  virtual void commit_with(atomic_file& file) = 0;
};

/// The files of a format that is a folder, for its writer.
struct folder_sink {
  virtual ~folder_sink() = default;
  /// Where to write the file of that name. It stays valid.
  virtual text_sink& file(std::string_view name) = 0;
  /// The folder has no file of that name afterwards.      Result: whether there is one now.
  virtual bool remove(std::string_view name) = 0;
};

/// The output text, the options and the report of a writer.
struct write_context {
  /// A property that the file stores.
  struct stored_property {
    element_kind kind;
    std::string name;
    const std::type_info* type;
  };

  text_sink& out;
  std::string_view name;       // for messages
  std::string_view path;       // of the file; empty if the output is a string, which has no companion files
  const save_options& options;
  save_report& report;
  std::vector<stored_property> stored = {};
  std::unique_ptr<companion_files> companions = {};  // created by the writer, if there are any
  folder_sink* folder = nullptr;  // of formats that are folders, which write nothing to `out`; else null
  std::size_t num_elements = 0, num_written = 0;        // verts and polys
  std::size_t num_not_finite = 0;

  /// Called once for every vert and poly; calls options.progress from time to time. Errors: cancelled.
  void report_progress() {
    if (num_written++ % 4096 == 0)
      detail::report_progress(options.progress,
                              std::min(1.0, static_cast<double>(num_written) / static_cast<double>(num_elements + 1)),
                              "writing");
  }

  /// Declares that the file stores the property of that name with values of type T. All others are reported as lost.
  template<class T>
  void declare_stored(element_kind kind, std::string_view property) { declare_stored(kind, property, typeid(T)); }
  void declare_stored(element_kind kind, std::string_view property, const std::type_info& type) {
    stored.push_back({kind, std::string(property), &type});
  }

  /// A number other than a coordinate, for output: files cannot hold a number that is not finite, so it becomes 0,
  /// which is reported.
  double finite(double x) {
    if (std::isfinite(x)) return x;
    ++num_not_finite;
    return 0;
  }
  float finite(float x) { return static_cast<float>(finite(static_cast<double>(x))); }

  /// Errors: unsupported, "<name>: <format> cannot hold <what>; save it as <instead>".
  [[noreturn, gnu::noinline, gnu::cold]] void throw_cannot_hold(std::string_view format, core::message what,
                                                                std::string_view instead) const {
    core::throw_joined<unsupported>(
        {name, ": ", format, " cannot hold ", core::joined(what), "; save it as ", instead});
  }
};

}  // namespace concino
