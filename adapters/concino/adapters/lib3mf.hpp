// Adapter for 3MF files, which printers in three dimensions take, through lib3mf: save_3mf(m, path).
// Needs: lib3mf 1.8 (Debian: lib3mf-dev), linked by -l3MF; its headers lie in the folder lib3mf of the system.
//
//   concino::save_3mf(m, "part.3mf", {.as_triangles = true, .as_boundary = true});
//   concino::save(m, path, concino::standard_formats + concino::lib3mf_format{});   // by the extension, with others
#pragma once

#include <concino/adapters/detail/lib3mf_model.hpp>
#include <concino/io/save.hpp>

namespace concino {

/// The 3MF format, which is only written: triangles in millimetres, with "color" of verts, else of polys.
struct lib3mf_format {
  static constexpr std::string_view name = "3mf";
  static constexpr std::string_view extensions[] = {".3mf"};
  static constexpr bool holds_surfaces = true, holds_volumes = false;
  static constexpr bool is_write_only = true;
  static constexpr bool has_binary = true;  // it is always binary

  /// Needs:  the points are finite.
  /// Result: one object: a model if the triangles are a closed, oriented manifold, else a surface. The mesh property
  ///         "name" (std::string) is its name. Colours have 8 bits, coordinates 32 bits and six decimals.
  /// Cost:   O(corners); the whole file is in memory.
  /// Errors: unsupported if a poly is no triangle, unless options.as_triangles is set, if a coordinate is beyond 1e9,
  ///         or if lib3mf fails, with its reason. cancelled.
  static void write(write_context& c, flat_mesh& m) { detail::lib3mf_model(c, m).write(); }
};
static_assert(Format<lib3mf_format>);

/// Writes a mesh to a 3MF file, whatever its extension.
/// Needs:  a mesh with points, of any type: a surface, or a volume with options.as_boundary.
/// Result: the complete file, which replaces an existing one, as by save; equal meshes give equal files.
/// Cost:   as lib3mf_format::write.
/// Errors: as save, and lib3mf_format::write.
template<EmbeddedMesh M>
void save_3mf(const M& m, const std::string& path, const save_options& options = {}) {
  save(m, path, lib3mf_format{}, options);
}

}  // namespace concino
