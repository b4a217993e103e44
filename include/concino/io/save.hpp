// Writes a mesh of any type to a file.
#pragma once

#include <concino/io/write_hedra.hpp>
#include <concino/io/write_medit.hpp>
#include <concino/io/write_obj.hpp>

namespace concino {

namespace detail {

template<class M>
void write_to(text_sink& out, const M& m, std::string_view name, file_format format, const save_options& options) {
  save_report unheard, &report = options.report ? *options.report : unheard;
  report = {};
  write_context<M> context(m, name, out, report, options.progress);
  if (format == file_format::obj) write_obj(context);
  else if (format == file_format::medit) write_medit(context);
  else write_hedra(context);
  tell_of_lost_properties(m, format == file_format::medit, extension_of(format), report.lost);
}

}  // namespace detail

/// Writes a mesh to a file; which format follows from the extension: .obj for surfaces; .mesh for triangles and quads, or for tets, hexes,
/// prisms and pyramids, which are told by their faces; .hedra for volumes.
/// Needs:  a surface or volume mesh with points, of any type.
/// Result: the file, complete, in the place of what was there; coordinates read back as the same numbers. Verts (and faces) are numbered as
///         they are walked. A property "label" (int) of verts and polys goes to .mesh; properties that are lost are named in
///         options.report.
/// Cost:   O(size of the mesh) time; O(verts) memory, O(corners) for .mesh.
/// Errors: unsupported if the extension is not known, or the format cannot hold the mesh, naming the first poly that it cannot and formats
///         that can; invalid_mesh if a coordinate is not finite; io_error if the file cannot be written; cancelled. The target then is as
///         it was.
template<class M>
  requires(AnyMesh<M> && Embedded<M>)
void save(const M& m, const std::string& path, const save_options& options = {}) {
  const file_format format = detail::format_of(path, options.format);
  detail::replacing_file file(path);
  detail::text_sink out(file.descriptor(), path);
  detail::write_to(out, m, path, format, options);
  out.flush();
  if (options.progress) detail::tell(options.progress, 1.0, "writing");
  file.commit();
}

/// The text that save would write.
/// Errors: as save, but io_error; invalid_argument if no format is given.
template<class M>
  requires(AnyMesh<M> && Embedded<M>)
std::string save_text(const M& m, file_format format, const save_options& options = {}) {
  if (format == file_format::by_extension) throw invalid_argument("save_text: say which format to write; text has no extension");
  detail::text_sink out;
  detail::write_to(out, m, "text", format, options);
  return std::move(out).take();
}

}  // namespace concino
