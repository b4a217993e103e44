// The implementation of all functions that load meshes, for any list of formats.
#pragma once

#include <concino/concepts/mesh_traits.hpp>
#include <concino/io/detail/formats/choose_format.hpp>
#include <concino/io/detail/formats/contents.hpp>
#include <concino/io/detail/formats/mesh_folder.hpp>
#include <concino/io/detail/formats/mend_repeated_verts.hpp>
#include <concino/io/detail/values/properties.hpp>
#include <concino/io/file_text.hpp>
#include <concino/mesh/support/to_polyhedra.hpp>

#include <cassert>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace concino {

namespace detail {

/// Replaces the offsets by an arity if all polys have the same size.
inline void drop_equal_offsets(surface_arrays& a) {
  if (a.arity != 0 || a.offsets.size() < 2 || a.offsets.front() != 0 || a.offsets.back() != a.verts.size()) return;
  const std::uint32_t size = a.offsets[1];
  for (std::size_t p = 0; p + 1 < a.offsets.size(); ++p)
    if (a.offsets[p + 1] < a.offsets[p] || a.offsets[p + 1] - a.offsets[p] != size) return;
  if (size == 0) return;
  a.arity = size;
  a.offsets.clear();
}

/// Whether a format can be read without the arrays of volumes. True for formats that hold no surfaces or are not read,
/// as no surface is read from them.
template<class F>
inline constexpr bool reads_surfaces_alone =
    !F::holds_surfaces || requirement::is_write_only<F> || requires(const read_context& in, file_contents& out) {
  F::read(in, out);
};

/// Reads in format F. Readers of surfaces or volumes that are not wanted are not compiled.
template<Format F, bool Surfaces, bool Volumes, class Contents>
void read_as(const read_context& context, Contents& out) {
  *context.report = {};
  if (requirement::is_folder<F> && !context.is_file)
    core::throw_joined<unsupported>(
        {context.name, ": a mesh in the format ", F::name, " is a folder of files, no text; load it by its path"});
  out.repeated.policy = context.repeated_verts;
  if constexpr (requirement::is_write_only<F>) assert(false);  // never chosen
  else if constexpr ((Surfaces && F::holds_surfaces) || (Volumes && F::holds_volumes)) F::read(context, out);
  else throw_wrong_dimension(context.name, F::holds_volumes);
  if (context.repeated_verts != repeated_verts::refuse) {
    std::size_t num_polys = 0;
    if constexpr (requires { out.cells; })
      num_polys = out.filled == arrays_kind::cells ? out.cells.num_polys() : out.polyhedra.num_polys();
    mend_repeated_verts(out, num_polys, *context.report);
  }
  drop_equal_offsets(out.surface);
  report_progress(*context.progress, 1.0, "reading");
}

/// Whether formats declare that their files have no other values than properties.
template<class F>
inline constexpr bool declares_only_properties = requirement::is_write_only<F> || requires {
  requires F::has_only_properties;
};
template<class... F>
constexpr bool all_have_only_properties(format_list<F...>) { return (declares_only_properties<F> && ...); }
template<Formats F>
inline constexpr bool only_properties = all_have_only_properties(list_of(F{}));

/// Constructs a mesh from the contents, if M can hold them. OnlyProperties: as for set_properties.
template<class M, bool OnlyProperties = false>
M mesh_of(file_contents& contents, std::string_view, load_report* report) {
  M m(std::move(contents.surface));
  set_properties<OnlyProperties>(m, contents, report);
  return m;
}
template<class M, bool OnlyProperties = false>
M mesh_of(volume_contents& contents, std::string_view name, load_report* report) {
  const auto with_properties = [&](M m) {
    set_properties<OnlyProperties>(m, contents, report);
    return m;
  };
  if (contents.filled == arrays_kind::surface) {
    if constexpr (from_surface<M>) return with_properties(M(std::move(contents.surface)));
    else throw_wrong_dimension(name, false, contents.surface.num_polys());
  } else if (contents.filled == arrays_kind::cells) {
    if constexpr (from_cells<M>) return with_properties(M(std::move(contents.cells)));
    else if constexpr (from_polyhedra<M>) return with_properties(M(to_polyhedra(std::move(contents.cells))));
    else throw_wrong_dimension(name, true, contents.cells.num_polys());
  } else {
    if constexpr (from_polyhedra<M>) return with_properties(M(std::move(contents.polyhedra)));
    else throw_wrong_dimension(name, true, contents.polyhedra.num_polys());
  }
}

/// The contents that M can hold.
template<class M>
inline constexpr wanted_mesh wanted_for{from_surface<M>, from_cells<M>, from_polyhedra<M>,
                                        static_cast<std::uint32_t>(arity_v<M>)};

template<class M> inline constexpr bool wants_volumes = from_cells<M> || from_polyhedra<M>;

template<class... F>
constexpr bool all_read_surfaces_alone(format_list<F...>) { return (reads_surfaces_alone<F> && ...); }

/// The type of contents that readers of these formats fill for M.
template<class M, Formats F>
using contents_for = contents_of<wants_volumes<M> || !all_read_surfaces_alone(list_of(F{}))>;

/// Reads a text in the chosen format. If it is the text of `file`, closes the file as soon as it is read.
template<bool Surfaces, bool Volumes, class... F, class Contents>
void read_text(std::string_view text, std::string_view name, format_list<F...> known, std::size_t chosen,
               const wanted_mesh& wanted, const load_options& options, Contents& contents, file_text* file = nullptr) {
  load_report unused_report;
  load_report* const report = options.report ? options.report : &unused_report;
  const read_context context{text,
                             name,
                             wanted,
                             report,
                             &options.progress,
                             file != nullptr,
                             options.inflate,
                             options.repeated_verts,
                             options.corners_only};
  with_format(known, chosen, [&]<Format G>(G) { read_as<G, Surfaces, Volumes>(context, contents); });
  if (file) file->close(std::string(name));
}

template<bool Surfaces, bool Volumes, Formats F, class Contents>
void read_file(const std::string& path, F formats, const wanted_mesh& wanted, const load_options& options,
               Contents& contents) {
  const auto known = list_of(formats);
  const format_rows rows = format_rows_of(known);
  const std::uint64_t candidates = candidates_for(path, formats, options.format);
  const bool by_extension = !Format<F> && options.format == format_id();
  std::string folder;
  if (const std::size_t chosen = choose_folder(path, candidates, by_extension, rows, folder); chosen != no_folder) {
    file_text none;  // the reader opens the files of the folder
    return read_text<Surfaces, Volumes>({}, folder, known, chosen, wanted, options, contents, &none);
  }
  file_text file(path, {.map = options.map, .pipes = true});
  const std::string_view text = file.text();
  std::string note;
  const std::size_t chosen =
      by_extension ? choose_by_text(path, candidates, rows, text, note)
                   : choose_format(readable(path, candidates, rows), rows, &text);
  read_text<Surfaces, Volumes>(text, path, known, chosen, wanted, options, contents, &file);
  if (!note.empty() && options.report) options.report->notes.push_back(std::move(note));
}

template<class M, Formats F>
M load_text_with(std::string_view text, std::string_view name, F formats, const load_options& input_options) {
  const core::profiled_options profiled(input_options, "load_text");
  const load_options& options = *profiled;
  const auto known = list_of(formats);
  contents_for<M, F> contents;
  const format_rows rows = format_rows_of(known);
  const std::size_t chosen =
      choose_format(readable(name, candidates_for({}, formats, options.format), rows), rows, &text);
  read_text<from_surface<M>, wants_volumes<M>>(text, name, known, chosen, wanted_for<M>, options, contents);
  return mesh_of<M, only_properties<F>>(contents, name, options.report);
}

template<class M, Formats F>
M load_with(const std::string& path, F formats, const load_options& options) {
  const core::profiled_options profiled(options, "load");
  contents_for<M, F> contents;
  read_file<from_surface<M>, wants_volumes<M>>(path, formats, wanted_for<M>, *profiled, contents);
  return mesh_of<M, only_properties<F>>(contents, path, options.report);
}

}  // namespace detail

/// A type that load() can return: one constructible from surface_arrays, cell_arrays or polyhedra_arrays. These arrays
/// are Loadable too.
template<class M> concept Loadable = detail::from_surface<M> || detail::from_cells<M> || detail::from_polyhedra<M>;

}  // namespace concino
