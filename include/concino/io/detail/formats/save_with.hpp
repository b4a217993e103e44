// The implementation of all functions that save meshes, for any list of formats.
#pragma once

#include <concino/core/function_ref.hpp>
#include <concino/core/precompiled.hpp>
#include <concino/io/atomic_file.hpp>
#include <concino/io/detail/files/folder_files.hpp>
#include <concino/io/detail/formats/boundary_flat_mesh.hpp>
#include <concino/io/detail/formats/choose_format.hpp>
#include <concino/io/detail/formats/flat_mesh_of.hpp>
#include <concino/io/detail/formats/mesh_folder.hpp>

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace concino::detail {

/// Checks the coordinates. Errors: invalid_mesh if one is not finite, naming the vert by its index.
void check_savable_points(std::string_view name, const flat_mesh& m);

/// Reports what was lost. Called after the whole mesh is written.
void report_lost(const write_context& c, const flat_mesh& m, std::string_view format);

/// Reports faces of a volume that a reader will not find if the file lists the cells only: those with the verts of
/// another face, and those of no poly.
void report_lost_faces(save_report& report, flat_mesh& m, std::string_view format);

/// Errors: unsupported, with all that is lost.
[[noreturn, gnu::cold]] void throw_lossy(std::string_view name, const save_report& report);

/// A function that passes a mesh, as flat arrays, to a writer.
using flat_mesh_source = function_ref<void(function_ref<void(flat_mesh&)>)>;

/// Writes a mesh in format G, which can hold it.
template<Format G>
void write_flat(write_context& context, flat_mesh& flat, std::string_view extension) {
  check_savable_points(context.name, flat);
  context.num_elements = flat.points.size() + flat.num_polys;
  G::write(context, flat);
  report_lost(context, flat, extension);
}

/// Writes a mesh in the chosen format. Writers of volumes are not compiled for surfaces; those of surfaces are compiled
/// for volumes, as options.as_boundary asks for them. Returns the companion files, or null if there are none.
template<int Dimension, class... F>
std::unique_ptr<companion_files> write_with(text_sink& out, flat_mesh_source mesh, std::string_view name,
                                            std::string_view path, format_list<F...> known, std::size_t chosen,
                                            const save_options& options, folder_sink* folder = nullptr) {
  save_report unused_report, &report = options.report ? *options.report : unused_report;
  report = {};
  const format_row& row = format_rows_of(known).rows[chosen];
  if (options.binary && !row.has_binary)
    core::throw_joined<unsupported>(
        {name, ": ", row.extensions[0], " cannot be written in binary; use binary = false"});
  if (row.is_folder && !folder)
    core::throw_joined<unsupported>(
        {name, ": a mesh in the format ", row.name, " is a folder of files, no text; save it to a path"});
  write_context context{out, name, path, options, report};
  context.folder = folder;
  with_format(known, chosen, [&]<Format G>(G) {
    const std::string_view extension = row.extensions[0];
    if constexpr (requirement::is_read_only<G>) return;  // never chosen
    else {
      if constexpr (Dimension == 3) {
        if (options.as_boundary) {
          if constexpr (!G::holds_surfaces)
            context.throw_cannot_hold(extension, {"surfaces, such as the boundary of a volume"}, ".obj or .ply");
          else
            return mesh([&](flat_mesh& volume) {
              boundary_flat_mesh surface(volume);
              write_flat<G>(context, surface, extension);
              surface.report_lost(report);
            });
        }
      }
      if constexpr (Dimension == 2 ? G::holds_surfaces : G::holds_volumes) {  // a format may hold one of them only
        mesh([&](flat_mesh& flat) {
          write_flat<G>(context, flat, extension);
          // surfaces have no faces
          if constexpr (Dimension == 3 && !requires { requires G::holds_faces; })
            report_lost_faces(report, flat, extension);
        });
      } else if constexpr (Dimension == 2) {  // the message names formats that hold surfaces
        context.throw_cannot_hold(extension, {"surfaces"}, ".obj, or .mesh if it has triangles and quads only");
      } else {
        context.throw_cannot_hold(extension, {"volumes, unless options.as_boundary is set"}, ".mesh or .hedra");
      }
    }
  });
  return std::move(context.companions);
}

/// For save_options::strict: writes the mesh to nowhere. Errors: unsupported if anything is lost.
template<int Dimension, class... F>
void require_lossless(flat_mesh_source mesh, std::string_view name, std::string_view path, format_list<F...> known,
                      std::size_t chosen, const save_options& options) {
  save_report report;
  save_options dry = options;
  dry.report = &report;
  dry.progress = {};
  text_sink out = text_sink::nowhere();
  folder_nowhere folder;
  write_with<Dimension>(out, mesh, name, path, known, chosen, dry, path.empty() ? nullptr : &folder);
  if (!report.lost.empty()) throw_lossy(name, report);
}

template<int Dimension, Formats F>
void save_flat(flat_mesh_source mesh, const std::string& path, F formats, const save_options& input_options) {
  const core::profiled_options profiled(input_options, "save");
  const save_options& options = *profiled;
  const std::size_t chosen = chosen_for(path, formats, options.format);
  if (options.strict) require_lossless<Dimension>(mesh, path, path, list_of(formats), chosen, options);
  if (const format_row& row = format_rows_of(list_of(formats)).rows[chosen]; row.is_folder) {
    folder_files files(folder_to_write(path, row), options.sync);
    text_sink unused = text_sink::nowhere();
    write_with<Dimension>(unused, mesh, path, path, list_of(formats), chosen, options, &files);
    files.finish();
    if (options.progress) report_progress(options.progress, 1.0, "writing");
    return files.commit();
  }
  atomic_file file(path, {.sync = options.sync});
  text_sink out(file.descriptor(), path);
  const std::unique_ptr<companion_files> companions =
      write_with<Dimension>(out, mesh, path, path, list_of(formats), chosen, options);
  out.flush();
  file.finish();
  if (options.progress) report_progress(options.progress, 1.0, "writing");
  if (companions) companions->commit_with(file);
  else file.commit();
}

template<int Dimension, Formats F>
std::string flat_text(flat_mesh_source mesh, F formats, const save_options& input_options) {
  const core::profiled_options profiled(input_options, "save_text");
  const save_options& options = *profiled;
  const std::size_t chosen = chosen_for({}, formats, options.format);
  if (options.strict) require_lossless<Dimension>(mesh, "text", {}, list_of(formats), chosen, options);
  text_sink out;
  write_with<Dimension>(out, mesh, "text", {}, list_of(formats), chosen, options);
  return std::move(out).release();
}

/// The same as visit_flat_mesh, defined in the compiled library only.
template<class M>
void visit_precompiled_flat_mesh(const M& m, function_ref<void(flat_mesh&)> f);

template<class M>
void visit_flat_mesh(const M& m, function_ref<void(flat_mesh&)> f) {
  if constexpr (core::is_precompiled<M>) {
    visit_precompiled_flat_mesh(m, f);
  } else {
    flat_mesh_of<M> flat(m);
    f(flat);
  }
}

/// A flat_mesh_source for a mesh of type M.
template<class M>
struct visitable_mesh {
  const M& m;
  void operator()(function_ref<void(flat_mesh&)> f) const { visit_flat_mesh(m, f); }
};

template<class M, Formats F>
void save_with(const M& m, const std::string& path, F formats, const save_options& options) {
  save_flat<dimension_v<M>>(visitable_mesh<M>{m}, path, formats, options);
}

template<class M, Formats F>
std::string save_text_with(const M& m, F formats, const save_options& options) {
  return flat_text<dimension_v<M>>(visitable_mesh<M>{m}, formats, options);
}

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/io/detail/formats/save_with.ipp>
#endif
