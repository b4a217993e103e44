// Bodies of skeleton.hpp: reads and writes curve skeletons: .skel, .cg, .skc and .csv.
#pragma once

#include <concino/core/error.hpp>
#include <concino/io/atomic_file.hpp>
#include <concino/io/detail/files/paths.hpp>
#include <concino/io/detail/formats/choose_format.hpp>
#include <concino/io/detail/skeleton/read_cg.hpp>
#include <concino/io/detail/skeleton/read_csv.hpp>
#include <concino/io/detail/skeleton/read_skc.hpp>
#include <concino/io/detail/skeleton/read_skel.hpp>
#include <concino/io/detail/text/characters.hpp>
#include <concino/io/file_text.hpp>
#include <concino/io/skeleton.hpp>
#include <concino/io/text_sink.hpp>

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace concino {

namespace detail {

inline constexpr format_rows skeleton_formats{
    all_format_rows<file_format::cg_format, file_format::skc_format, file_format::skel_format,
                    file_format::csv_format>::rows.data(),
    4};

/// The name of the format of a text: that of the options, or that of its first words, or that of the extension.
inline std::string_view skeleton_format_of(std::string_view text, std::string_view name, bool is_file,
                                           const load_options& options, load_report& report) {
  const std::uint64_t candidates = formats_for(name, options.format, skeleton_formats);
  if (options.format != format_id())
    return skeleton_formats.rows[choose_format(candidates, skeleton_formats, nullptr)].name;
  std::string_view words = text.substr(text.starts_with("\xEF\xBB\xBF") ? 3 : 0);
  while (!words.empty() && is_space(words.front())) words.remove_prefix(1);
  std::string note;
  const format_row& row = skeleton_formats.rows[choose_by_text(name, candidates, skeleton_formats, words, note)];
  if (is_file && !note.empty()) report.notes.push_back(std::move(note));
  return row.name;
}

inline skeleton read_skeleton(std::string_view text, std::string_view name, bool is_file, const load_options& options) {
  load_report unused_report, &report = options.report ? *options.report : unused_report;
  report = {};
  const std::string_view format = skeleton_format_of(text, name, is_file, options, report);
  skeleton_contents contents;
  if (format == "skel") skel_reader(text, name, &options.progress, report, contents).read();
  else if (format == "cg") cg_reader(text, name, &options.progress, report, contents).read();
  else if (format == "skc") skc_reader(text, name, &options.progress, report, contents).read();
  else csv_reader(text, name, &options.progress, report, contents).read();
  report_progress(options.progress, 1.0, "reading");
  return skeleton(std::move(contents.points), std::move(contents.edges), std::move(contents.radii));
}

inline void check_skeleton(const skeleton& k, std::string_view name) {
  for (std::size_t v = 0; v < k.num_verts(); ++v)
    if (const vec3& p = k.points()[v];
        !std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z) || !std::isfinite(k.radius(vert_id{v})))
      core::throw_joined<invalid_mesh>(
          {name, ": vert ", v, " has a coordinate or a radius that is not a finite number; no file can hold it"});
}

inline void write_skel(const skeleton& k, text_sink& out) {
  out << "ID Cx Cy Cz RADIUS #NEIGHBORS NEIGHBORS_LIST\n" << k.num_verts() << '\n';
  for (std::size_t v = 0; v < k.num_verts(); ++v) {
    const vec3& p = k.points()[v];
    const id_span<vert_id> neighbours = k.neighbours(vert_id{v});
    out << v << ' ' << p.x << ' ' << p.y << ' ' << p.z << ' ' << k.radius(vert_id{v}) << ' ' << neighbours.size();
    for (const vert_id w : neighbours) out << ' ' << w.raw();
    out << '\n';
  }
}

inline void write_cg(const skeleton& k, text_sink& out) {
  out << "# D:3 NV:" << k.num_verts() << " NE:" << k.num_edges() << '\n';
  for (std::size_t v = 0; v < k.num_verts(); ++v) {
    const vec3& p = k.points()[v];
    out << "v " << p.x << ' ' << p.y << ' ' << p.z;
    if (k.has_radii()) out << ' ' << k.radii()[v];
    out << '\n';
  }
  for (const auto& [a, b] : k.edges())
    out << "e " << std::uint64_t{a.raw()} + 1 << ' ' << std::uint64_t{b.raw()} + 1 << '\n';
}

inline void write_skeleton(const skeleton& k, text_sink& out, std::string_view name, const save_options& options) {
  save_report unused_report, &report = options.report ? *options.report : unused_report;
  report = {};
  const std::uint64_t candidates =
      writable(name, formats_for(name, options.format, skeleton_formats), skeleton_formats);
  const std::string_view format = skeleton_formats.rows[choose_format(candidates, skeleton_formats, nullptr)].name;
  if (options.binary)
    core::throw_joined<unsupported>({name, ": .", format, " cannot be written in binary; use binary = false"});
  check_skeleton(k, name);
  report_progress(options.progress, 0.0, "writing");
  if (format == "skel") write_skel(k, out);
  else write_cg(k, out);
}

}  // namespace detail

CONCINO_INLINE skeleton load_skeleton_text(std::string_view text, const load_options& options, std::string_view name) {
  const core::profiled_options profiled(options, "load_skeleton_text");
  return detail::read_skeleton(text, name, false, *profiled);
}

CONCINO_INLINE skeleton load_skeleton(const std::string& path, const load_options& options) {
  const core::profiled_options profiled(options, "load_skeleton");
  detail::check_path(path);
  file_text file(path, {.map = options.map, .pipes = true});
  skeleton k = detail::read_skeleton(file.text(), path, true, *profiled);
  file.close(path);
  return k;
}

CONCINO_INLINE void save_skeleton(const skeleton& k, const std::string& path, const save_options& input_options) {
  const core::profiled_options profiled(input_options, "save_skeleton");
  const save_options& options = *profiled;
  atomic_file file(path, {.sync = options.sync});
  text_sink out(file.descriptor(), path);
  detail::write_skeleton(k, out, path, options);
  out.flush();
  file.finish();
  detail::report_progress(options.progress, 1.0, "writing");
  file.commit();
}

CONCINO_INLINE std::string save_skeleton_text(const skeleton& k, const save_options& options) {
  const core::profiled_options profiled(options, "save_skeleton_text");
  text_sink out;
  detail::write_skeleton(k, out, "text", *profiled);
  return std::move(out).release();
}

}  // namespace concino
