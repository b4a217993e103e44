// Writes a mesh of any type to a file.
#pragma once

#include <concino/io/write_hedra.hpp>
#include <concino/io/write_medit.hpp>
#include <concino/io/write_obj.hpp>
#include <concino/io/write_off.hpp>

namespace concino {

namespace detail {

/// Where there may be a file beside this one, `library` is filled in with its text if it is needed.
template<class M>
void write_to(text_sink& out, const M& m, std::string_view name, file_format format, const save_options& options,
              std::string* library = nullptr, std::string_view library_name = {}) {
  save_report unheard, &report = options.report ? *options.report : unheard;
  report = {};
  if (options.binary && format != file_format::off)
    throw_joined<unsupported>({name, ": ", extension_of(format), " has no binary form here"});
  write_context<M> context(m, name, out, report, options.progress);
  context.library = library;
  context.library_name = library_name;
  if (format == file_format::obj) write_obj(context);
  else if (format == file_format::off) write_off(context, options.binary);
  else if (format == file_format::medit) write_medit(context);
  else write_hedra(context);
  if constexpr (HasProperties<M>)
    tell_of_lost_properties(traits<M>::properties(m), context.kept, context.num_kept, extension_of(format), report.lost);
  if (context.num_not_finite)
    report.lost.push_back(joined({context.num_not_finite, " numbers of colours and the like that are not finite: written as 0"}));
}

/// a/b.obj: a/b.mtl
[[gnu::noinline, gnu::cold]] inline std::string library_path(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  const bool has_extension = dot != std::string::npos && path.find('/', dot) == std::string::npos;
  return joined({std::string_view(path).substr(0, has_extension ? dot : path.size()), ".mtl"});
}

}  // namespace detail

/// Writes a mesh to a file; which format follows from the extension: .obj and .off for surfaces; .mesh for triangles and quads, or for
/// tets, hexes, prisms and pyramids, which are told by their faces; .hedra for volumes. Needs:  a surface or volume mesh with points, of
/// any type. Result: the file, complete, in the place of what was there; coordinates read back as the same numbers. Verts (and faces) are
/// numbered as
///         they are walked. Properties "label" (int) of verts and polys go to .mesh; "color" (rgba) and "label" of polys, of which .off
///         holds one, and "color" of verts to .obj and .off; "normal" (vec3) and "texture" (std::array<double, 2>) of verts to .off;
///         "object", "group" and "material" (std::string) of polys to .obj. Colours of polys make a material library of the same name,
///         .mtl, beside the .obj. Whatever is lost is named in options.report.
/// Cost:   O(size of the mesh) time; O(verts) memory, O(corners) for .mesh.
/// Errors: unsupported if the extension is not known, or the format cannot hold the mesh, naming the first poly that it cannot and formats
///         that can; invalid_mesh if a coordinate is not finite; io_error if the file cannot be written; cancelled. The target then is as
///         it was.
template<class M>
  requires(AnyMesh<M>&& Embedded<M>)
void save(const M& m, const std::string& path, const save_options& options = {}) {
  const file_format format = detail::format_of(path, options.format);
  detail::replacing_file file(path);
  detail::text_sink out(file.descriptor(), path);
  std::string library;
  const std::string beside = detail::library_path(path);
  detail::write_to(out, m, path, format, options, &library, std::string_view(beside).substr(beside.rfind('/') + 1));
  out.flush();
  if (!library.empty()) {
    detail::replacing_file other(beside);
    detail::text_sink text(other.descriptor(), beside);
    text << library;
    text.flush();
    other.commit();
  }
  if (options.progress) detail::tell(options.progress, 1.0, "writing");
  file.commit();
}

/// The text that save would write.
/// Errors: as save, but io_error; invalid_argument if no format is given.
template<class M>
  requires(AnyMesh<M>&& Embedded<M>)
std::string save_text(const M& m, file_format format, const save_options& options = {}) {
  if (format == file_format::by_extension) throw invalid_argument("save_text: say which format to write; text has no extension");
  detail::text_sink out;
  detail::write_to(out, m, "text", format, options);
  return std::move(out).take();
}

}  // namespace concino
