// Reads a mesh of the wanted type from a file.
#pragma once

#include <concino/concepts/mesh_traits.hpp>
#include <concino/io/detail/properties.hpp>
#include <concino/io/detail/read_hedra.hpp>
#include <concino/io/detail/read_medit.hpp>
#include <concino/io/detail/read_obj.hpp>
#include <concino/io/detail/read_off.hpp>
#include <concino/io/file_text.hpp>
#include <concino/mesh/face_soup.hpp>

#include <concepts>

namespace concino {

namespace detail {

/// Readers of what is not wanted are not compiled.
template<bool Surfaces, bool Volumes>
void read_contents(const read_context& context, file_format format, contents_of<Volumes>& out) {
  *context.report = {};
  if (format == file_format::obj) {
    if constexpr (Surfaces) read_obj(context, out);
    else throw_wrong_dimension(context.name, false);
  } else if (format == file_format::off) {
    if constexpr (Surfaces) read_off(context, out);
    else throw_wrong_dimension(context.name, false);
  } else if (format == file_format::medit) {
    read_medit<Surfaces, Volumes>(context, out);
  } else {
    if constexpr (Volumes) read_hedra(context, out);
    else throw_wrong_dimension(context.name, true);
  }
  tell(*context.progress, 1.0, "reading");
}

/// Of what M can be.
template<class M>
M mesh_of(file_contents& contents, load_report* report) {
  M m(std::move(contents.surface));
  give_properties(m, contents, report);
  return m;
}
template<class M>
M mesh_of(volume_contents& contents, std::string_view name, load_report* report) {
  const auto with_properties = [&](M m) {
    give_properties(m, contents, report);
    return m;
  };
  if (contents.held == held_mesh::surface) {
    if constexpr (from_surface<M>) return with_properties(M(std::move(contents.surface)));
    else throw_wrong_dimension(name, false, contents.surface.num_polys());
  } else if (contents.held == held_mesh::cells) {
    if constexpr (from_cells<M>) return with_properties(M(std::move(contents.cells)));
    else if constexpr (from_polyhedra<M>) return with_properties(M(to_polyhedra(std::move(contents.cells))));
    else throw_wrong_dimension(name, true, contents.cells.num_polys());
  } else {
    if constexpr (from_polyhedra<M>) return with_properties(M(std::move(contents.polyhedra)));
    else throw_wrong_dimension(name, true, contents.polyhedra.num_polys());
  }
}

/// From a file if there is one, which is let go as soon as it is read; else from the text.
template<class M>
M load_from(std::string_view text, std::string_view name, file_format format, const load_options& options, file_text* file = nullptr) {
  constexpr bool surface = from_surface<M>, volume = from_cells<M> || from_polyhedra<M>;
  load_report unheard;
  const wanted_mesh wanted{surface, from_cells<M>, from_polyhedra<M>, static_cast<std::uint32_t>(arity_v<M>)};
  contents_of<volume> contents;
  read_contents<surface, volume>({text, name, wanted, options.report ? options.report : &unheard, &options.progress, file != nullptr}, format, contents);
  if (file) file->close(std::string(name));
  if constexpr (volume) return mesh_of<M>(contents, name, options.report);
  else return mesh_of<M>(contents, options.report);
}

}  // namespace detail

/// What load() can make: anything constructible from surface_arrays, cell_arrays or polyhedra_arrays, which are themselves of the kind.
template<class M> concept Loadable = detail::from_surface<M> || detail::from_cells<M> || detail::from_polyhedra<M>;

/// Reads a mesh from a file; which format it is in follows from the extension: .obj, .off, .mesh, .hedra, in any case.
/// Needs:  Loadable M.
/// Result: the mesh, elements in the order of the file. Any volume becomes a polyhedralmesh, any surface a polygonmesh; the other kinds
///         take only what they can hold. What the file says of its elements becomes properties, which are made only where it says any:
///         "label" (int) and "color" (rgba) of verts and polys; "normal" (vec3) and "texture" (std::array<double, 2>) of verts from .off;
///         "object", "group" and "material" (std::string) of polys from .obj, with colours from the .mtl files beside it, of which the mesh
///         property "materials" (material_table) keeps all lines. What was skipped, turned or worth a remark is in options.report.
/// Cost:   one pass over the file, which is read into memory as a whole (or mapped: options.map); the arrays are handed over to the mesh.
/// Errors: io_error if the file cannot be read, or shrinks or grows meanwhile; parse_error with the line if it breaks its format or holds a
///         poly that M cannot; unsupported if the extension is not known, or the file holds a volume and M is a surface, or the reverse, or
///         faces of more than 16 verts belong to very many polyhedra; cancelled.
template<Loadable M>
M load(const std::string& path, const load_options& options = {}) {
  const file_format format = detail::format_of(path, options.format);
  file_text file(path, {.map = options.map, .pipes = true});
  return detail::load_from<M>(file.text(), path, format, options, &file);
}

/// The same from memory, without material libraries. `name` is what messages call the text.
/// Needs:  Loadable M; the format, which no extension says.
/// Result: as load, but no colours and no "materials" of material libraries.
/// Cost:   one pass over the text.
/// Errors: as load, but io_error; invalid_argument if no format is given.
template<Loadable M>
M load_text(std::string_view text, file_format format, const load_options& options = {}, std::string_view name = "text") {
  if (format == file_format::by_extension) throw invalid_argument("load_text: say which format the text is in; it has no extension");
  return detail::load_from<M>(text, name, format, options);
}

// What to write instead of calls that cannot compile.
template<class M, class R = mistake::remedy<"files are read as a mesh of this library, auto m = load<polygonmesh>(path); convert<To>(m) makes others of it">>
  requires(!Loadable<M>)
M load(...) = delete;  // load<trimesh>(path), load<polygonmesh>(path) ..., then convert<To>(m)
template<class M, class R = mistake::remedy<"texts are read as a mesh of this library, auto m = load_text<polygonmesh>(text, format); convert<To>(m) makes others of it">>
  requires(!Loadable<M>)
M load_text(...) = delete;  // load_text<trimesh>(text, format) ..., then convert<To>(m)

}  // namespace concino
