// Bodies of slices.hpp: reads and writes slices of a part for layered manufacturing: files of the Common Layer
// Interface (.cli), as text or binary.
#pragma once

#include <concino/io/atomic_file.hpp>
#include <concino/io/detail/files/paths.hpp>
#include <concino/io/detail/slices/read_cli.hpp>
#include <concino/io/detail/slices/write_cli.hpp>
#include <concino/io/file_text.hpp>
#include <concino/io/slices.hpp>

namespace concino {

namespace detail {

CONCINO_INLINE void check_cli(std::string_view name, format_id format) {
  if (format != format_id() && format != format_id(file_format::cli))
    core::throw_joined<unsupported>(
        {name, ": the format ", format.name(), " holds no slices; the format of slices is cli"});
}

CONCINO_INLINE void write_slices(const slices& s, text_sink& out, std::string_view name, const save_options& options) {
  check_cli(name, options.format);
  save_report unused_report, &report = options.report ? *options.report : unused_report;
  report = {};
  cli_writer(s, out, name, options, report).write();
}

}  // namespace detail

CONCINO_INLINE slices load_slices_text(std::string_view text, const load_options& input_options,
                                       std::string_view name) {
  const core::profiled_options profiled(input_options, "load_slices_text");
  const load_options& options = *profiled;
  detail::check_cli(name, options.format);
  load_report unused_report, &report = options.report ? *options.report : unused_report;
  report = {};
  slices s;
  detail::cli_reader(text, name, &options.progress, report, s).read();
  detail::report_progress(options.progress, 1.0, "reading");
  return s;
}

CONCINO_INLINE slices load_slices(const std::string& path, const load_options& options) {
  const core::profiled_options profiled(options, "load_slices");
  detail::check_path(path);
  file_text file(path, {.map = options.map, .pipes = true});
  slices s = load_slices_text(file.text(), *profiled, path);
  file.close(path);
  return s;
}

CONCINO_INLINE void save_slices(const slices& s, const std::string& path, const save_options& input_options) {
  const core::profiled_options profiled(input_options, "save_slices");
  const save_options& options = *profiled;
  atomic_file file(path, {.sync = options.sync});
  text_sink out(file.descriptor(), path);
  detail::write_slices(s, out, path, options);
  out.flush();
  file.finish();
  detail::report_progress(options.progress, 1.0, "writing");
  file.commit();
}

CONCINO_INLINE std::string save_slices_text(const slices& s, const save_options& options) {
  const core::profiled_options profiled(options, "save_slices_text");
  text_sink out;
  detail::write_slices(s, out, "text", *profiled);
  return std::move(out).release();
}

}  // namespace concino
