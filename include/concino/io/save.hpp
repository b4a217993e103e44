// Writes a mesh of any type to a file.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/io/detail/write_hedra.hpp>
#include <concino/io/detail/write_medit.hpp>
#include <concino/io/detail/write_obj.hpp>
#include <concino/io/detail/write_off.hpp>
#include <concino/io/replacing_file.hpp>

namespace concino {

namespace detail {

/// Materials go to `library`, where there may be a file beside this one.
template<class M>
void write_to(text_sink& out, const M& m, std::string_view name, file_format format, const save_options& options, library_file* library = nullptr) {
  save_report unheard, &report = options.report ? *options.report : unheard;
  report = {};
  if (options.binary && format != file_format::off)
    core::throw_joined<unsupported>({name, ": ", extension_of(format), " has no binary form here"});
  write_context<M> context(m, name, out, report, options.progress);
  context.library = library;
  if (format == file_format::obj) write_obj(context);
  else if (format == file_format::off) write_off(context, options.binary);
  else if (format == file_format::medit) write_medit(context);
  else write_hedra(context);
  if constexpr (HasProperties<M>)
    tell_of_lost_properties(traits<M>::properties(m), context.kept, context.num_kept, extension_of(format), report.lost);
  if (context.num_not_finite)
    report.lost.push_back(core::joined({context.num_not_finite, " numbers of colours and the like that are not finite: written as 0"}));
}

}  // namespace detail

/// Writes a mesh to a file; which format follows from the extension: .obj and .off for surfaces; .mesh for triangles and quads, or for
/// tets, hexes, prisms and pyramids, which are told by their faces; .hedra for volumes.
/// Needs:  a surface or volume mesh with points, of any type.
/// Result: the file, complete, in the place of what was there; coordinates read back as the same numbers. Verts (and faces) are numbered as
///         they are walked. Properties "label" (int) of verts and polys go to .mesh; "color" (rgba) and "label" of polys, of which .off
///         holds one, and "color" of verts to .obj and .off; "normal" (vec3) and "texture" (std::array<double, 2>) of verts to .off;
///         "object", "group" and "material" (std::string) of polys to .obj, with all lines of the mesh property "materials". Colours and
///         materials are in the libraries that the mesh's file named, where these are beside the new one and hold the same; else in a new one
///         beside the .obj, of the same name, .mtl, or _1.mtl and so on: no library that is there is changed, but those that earlier saves
///         made for this file are removed. Both files change or neither does; killed at any moment, the .obj that is there finds its
///         materials. Whatever is lost, changed or called otherwise is named in options.report.
/// Cost:   O(size of the mesh) time; O(verts) memory, O(corners) for .mesh, O(polys) for .obj with colours or materials.
/// Errors: unsupported if the extension is not known, or the format cannot hold the mesh, naming the first poly that it cannot and formats
///         that can; invalid_mesh if a coordinate is not finite; io_error if a file cannot be written, or another program makes a library of
///         that name meanwhile; cancelled. The target then is as it was, and no other file has been made or changed. (With options.sync,
///         io_error also where the new file stands there but its folder cannot be brought to the disk.)
template<class M>
  requires(AnyMesh<M>&& Embedded<M>)
void save(const M& m, const std::string& path, const save_options& options = {}) {
  const file_format format = detail::format_of(path, options.format);
  replacing_file file(path, {.sync = options.sync});
  text_sink out(file.descriptor(), path);
  detail::library_file library(path, options.sync);
  detail::write_to(out, m, path, format, options, &library);
  out.flush();
  file.finish();
  if (options.progress) detail::tell(options.progress, 1.0, "writing");
  library.commit_with(file);
}

/// The text that save would write.
/// Needs:  as save; the format, which no extension says.
/// Result: the bytes of the file. Material libraries are not written.
/// Cost:   as save, and the memory of the text.
/// Errors: as save, but io_error; invalid_argument if no format is given.
template<class M>
  requires(AnyMesh<M>&& Embedded<M>)
std::string save_text(const M& m, file_format format, const save_options& options = {}) {
  if (format == file_format::by_extension) throw invalid_argument("save_text: say which format to write; text has no extension");
  text_sink out;
  detail::write_to(out, m, "text", format, options);
  return std::move(out).take();
}

// What to write instead of calls that cannot compile.
template<class... T> void save(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or a sibling
template<class... T> void save(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void save_text(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or a sibling
template<class... T> void save_text(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
