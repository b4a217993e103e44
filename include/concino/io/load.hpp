// Reads a mesh of the wanted type from a file.
#pragma once

#include <concino/concepts/mesh_traits.hpp>
#include <concino/io/mapped_file.hpp>
#include <concino/io/properties.hpp>
#include <concino/io/read_hedra.hpp>
#include <concino/io/read_medit.hpp>
#include <concino/io/read_obj.hpp>
#include <concino/io/read_off.hpp>
#include <concino/mesh/face_soup.hpp>

#include <concepts>

namespace concino {

namespace detail {

template<class M>
inline constexpr bool from_surface = std::constructible_from<M, surface_arrays&&>;
template<class M>
inline constexpr bool from_cells = std::constructible_from<M, cell_arrays&&>;
template<class M>
inline constexpr bool from_polyhedra = std::constructible_from<M, polyhedra_arrays&&>;

/// Readers of what M cannot be are not compiled.
template<class M>
file_contents read_contents(std::string_view text, std::string_view name, file_format format, const load_options& options, bool is_file) {
  constexpr bool surface = from_surface<M>, volume = from_cells<M> || from_polyhedra<M>;
  load_report unheard, &report = options.report ? *options.report : unheard;
  report = {};
  const wanted_mesh wanted{surface, from_cells<M>, from_polyhedra<M>, static_cast<std::uint32_t>(arity_v<M>)};
  const read_context context{text, name, wanted, &report, &options.progress, is_file};
  file_contents contents;
  if (format == file_format::obj) {
    if constexpr (surface) contents = read_obj(context);
    else throw_wrong_dimension(name, false);
  } else if (format == file_format::off) {
    if constexpr (surface) contents = read_off(context);
    else throw_wrong_dimension(name, false);
  } else if (format == file_format::medit) {
    contents = read_medit<surface, volume>(context);
  } else {
    if constexpr (volume) contents = read_hedra(context);
    else throw_wrong_dimension(name, true);
  }
  tell(options.progress, 1.0, "reading");
  return contents;
}

template<class M>
M mesh_of(file_contents&& contents, std::string_view name, load_report* report) {
  const auto with_properties = [&](M m) {
    give_properties(m, contents, report);
    return m;
  };
  if (auto* surface = std::get_if<surface_arrays>(&contents.arrays)) {
    if constexpr (from_surface<M>) return with_properties(M(std::move(*surface)));
    else throw_wrong_dimension(name, false, surface->num_polys());
  } else if (auto* cells = std::get_if<cell_arrays>(&contents.arrays)) {
    if constexpr (from_cells<M>) return with_properties(M(std::move(*cells)));
    else if constexpr (from_polyhedra<M>) return with_properties(M(to_polyhedra(std::move(*cells))));
    else throw_wrong_dimension(name, true, cells->num_polys());
  } else {
    auto& any = std::get<polyhedra_arrays>(contents.arrays);
    if constexpr (from_polyhedra<M>) return with_properties(M(std::move(any)));
    else throw_wrong_dimension(name, true, any.num_polys());
  }
}

template<class M>
M load_from(std::string_view text, std::string_view name, file_format format, const load_options& options, bool is_file) {
  return mesh_of<M>(read_contents<M>(text, name, format, options, is_file), name, options.report);
}

}  // namespace detail

/// What load() can make: anything constructible from surface_arrays, cell_arrays or polyhedra_arrays, which are themselves of the kind.
template<class M> concept Loadable = detail::from_surface<M> || detail::from_cells<M> || detail::from_polyhedra<M>;

/// Reads a mesh from a file; which format it is in follows from the extension: .obj, .off, .mesh, .hedra, in any case.
/// Needs:  Loadable M.
/// Result: the mesh, elements in the order of the file. Any volume becomes a polyhedralmesh, any surface a polygonmesh; the other kinds
///         take only what they can hold. What the file says of its elements becomes properties, which are made only where it says any:
///         "label" (int) and "color" (rgba) of verts and polys; "normal" (vec3) and "texture" (std::array<double, 2>) of verts from .off;
///         "object", "group" and "material" (std::string) of polys from .obj, with colours from the .mtl beside it. What was skipped,
///         turned or worth a remark is in options.report.
/// Cost:   one pass over the file, which is mapped, not copied; the arrays are handed over to the mesh.
/// Errors: io_error if the file cannot be read; parse_error with the line if it breaks its format or holds a poly that M cannot;
///         unsupported if the extension is not known, or the file holds a volume and M is a surface, or the reverse; cancelled.
template<Loadable M>
M load(const std::string& path, const load_options& options = {}) {
  const file_format format = detail::format_of(path, options.format);
  const detail::mapped_file file(path);
  return detail::load_from<M>(file.text(), path, format, options, true);
}

/// The same from memory, without material libraries. `name` is what messages call the text.
/// Errors: as load; invalid_argument if no format is given.
template<Loadable M>
M load_text(std::string_view text, file_format format, const load_options& options = {}, std::string_view name = "text") {
  if (format == file_format::by_extension) throw invalid_argument("load_text: say which format the text is in; it has no extension");
  return detail::load_from<M>(text, name, format, options, false);
}

}  // namespace concino
