// Reads a mesh of any kind from a file: the file determines the type.
#pragma once

#include <concino/io/load.hpp>
#include <concino/mesh/hexmesh.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>
#include <concino/mesh/quadmesh.hpp>
#include <concino/mesh/tetmesh.hpp>
#include <concino/mesh/trimesh.hpp>

#include <string>
#include <type_traits>
#include <variant>

namespace concino {

using any_mesh = std::variant<trimesh, quadmesh, polygonmesh, tetmesh, hexmesh, polyhedralmesh>;

namespace detail {

/// A mesh of the most special of the six kinds that can hold the contents.
template<class Variant>
Variant any_mesh_of(volume_contents& contents, const std::string& path, load_report* report) {
  const auto make = [&]<class M>(std::type_identity<M>) -> Variant { return mesh_of<M>(contents, path, report); };
  if (contents.filled == arrays_kind::surface) {
    if (contents.surface.arity == 3) return make(std::type_identity<trimesh>{});
    if (contents.surface.arity == 4) return make(std::type_identity<quadmesh>{});
    return make(std::type_identity<polygonmesh>{});
  }
  if (contents.filled == arrays_kind::cells)
    return contents.cells.arity == 4 ? make(std::type_identity<tetmesh>{}) : make(std::type_identity<hexmesh>{});
  return make(std::type_identity<polyhedralmesh>{});
}

}  // namespace detail

/// Reads a mesh as a variant of the six native types; std::visit calls a function with the actual mesh.
/// Needs:  a file in one of the formats of load.
/// Result: a mesh of the most special kind that can hold the file: triangles only, quads only, any polygons; tets only,
///         hexes only, any polyhedra. A .hedra or .hybrid file is always a polyhedralmesh. A file without polys is a
///         polygonmesh unless it says that it is a volume.
/// Cost:   as load.
/// Errors: as load, except for polys that do not fit the mesh: every kind of poly is accepted.
template<class Variant = any_mesh>  // a template only so that programs that do not call it need not compile six meshes
Variant load_any(const std::string& path, const load_options& options = {}) {
  const core::profiled_options profiled(options, "load_any");
  volume_contents contents;
  detail::read_standard_file<true, true>(path, {}, *profiled, contents);
  return detail::any_mesh_of<Variant>(contents, path, options.report);
}
/// `formats` as in load.
template<class Variant = any_mesh, Formats F>
Variant load_any(const std::string& path, F formats, const load_options& options = {}) {
  const core::profiled_options profiled(options, "load_any");
  volume_contents contents;
  detail::read_file<true, true>(path, formats, {}, *profiled, contents);
  return detail::any_mesh_of<Variant>(contents, path, options.report);
}

}  // namespace concino
