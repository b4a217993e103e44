// MEDIT .mesh, ASCII: triangles and quads, or tets, hexes, prisms and pyramids.
#pragma once

#include <concino/io/detail/load_with.hpp>
#include <concino/io/detail/read_medit.hpp>
#include <concino/io/detail/save_with.hpp>
#include <concino/io/detail/write_medit.hpp>

namespace concino {

/// Surfaces of triangles and quads; volumes of tets, hexes, prisms and pyramids; "label" of verts and polys.
struct medit_format {
  static constexpr std::string_view name = "medit";
  static constexpr std::string_view extensions[] = {".mesh"};
  static constexpr bool holds_surfaces = true, holds_volumes = true;

  static bool has_signature(std::string_view text) {
    token_cursor in(text, name, nullptr, '#');
    in.skip();
    return in.word() == "MeshVersionFormatted";
  }

  static void read(const read_context& in, file_contents& out) { detail::read_medit<false>(in, out); }
  template<std::same_as<volume_contents> Contents>
  static void read(const read_context& in, Contents& out) { detail::read_medit<true>(in, out); }
  static void write(write_context& out, flat_mesh& m) { detail::write_medit(out, m); }
};
static_assert(Format<medit_format>);

namespace file_format {

inline constexpr medit_format medit{};

}  // namespace file_format

/// Reads a mesh from a MEDIT file, whatever its extension; no other format is compiled.
/// Needs:  Loadable M.
/// Result: as load.
/// Cost:   as load.
/// Errors: as load, but for extensions.
template<Loadable M>
M load_medit(const std::string& path, const load_options& options = {}) {
  return detail::load_with<M>(path, file_format::medit, options);
}

/// Writes a mesh to a MEDIT file, whatever its extension; no other format is compiled.
/// Needs:  a mesh with points, of any type.
/// Result: as save.
/// Cost:   as save.
/// Errors: as save, but for extensions.
template<class M>
  requires(AnyMesh<M>&& Embedded<M>)
void save_medit(const M& m, const std::string& path, const save_options& options = {}) {
  detail::save_with(m, path, file_format::medit, options);
}

}  // namespace concino
