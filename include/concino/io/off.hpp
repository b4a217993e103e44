// Geomview OFF: surfaces with colours, normals and texture coordinates, as text or binary.
#pragma once

#include <concino/io/detail/load_with.hpp>
#include <concino/io/detail/read_off.hpp>
#include <concino/io/detail/save_with.hpp>
#include <concino/io/detail/write_off.hpp>

namespace concino {

/// Verts and polygons of any size; "color" of verts and polys, "label" of polys that have no colour, "normal" and "texture" of verts.
struct off_format {
  static constexpr std::string_view name = "off";
  static constexpr std::string_view extensions[] = {".off"};
  static constexpr bool holds_surfaces = true, holds_volumes = false;
  static constexpr bool has_binary = true;

  static void read(const read_context& in, file_contents& out) { detail::read_off(in, out); }
  static void write(write_context& out, flat_mesh& m) { detail::write_off(out, m); }
};
static_assert(Format<off_format>);

namespace file_format {

inline constexpr off_format off{};

}  // namespace file_format

/// Reads a mesh from an OFF file, whatever its extension; no other format is compiled.
/// Needs:  Loadable M, a surface.
/// Result: as load.
/// Cost:   as load.
/// Errors: as load, but for extensions.
template<Loadable M>
M load_off(const std::string& path, const load_options& options = {}) {
  return detail::load_with<M>(path, file_format::off, options);
}

/// Writes a mesh to an OFF file, whatever its extension; no other format is compiled.
/// Needs:  a surface mesh with points, of any type.
/// Result: as save.
/// Cost:   as save.
/// Errors: as save, but for extensions.
template<class M>
  requires(AnyMesh<M>&& Embedded<M>)
void save_off(const M& m, const std::string& path, const save_options& options = {}) {
  detail::save_with(m, path, file_format::off, options);
}

}  // namespace concino
