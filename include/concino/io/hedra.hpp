// .hedra, the format of Cinolib: volumes of any polyhedra.
#pragma once

#include <concino/io/detail/load_with.hpp>
#include <concino/io/detail/read_hedra.hpp>
#include <concino/io/detail/save_with.hpp>
#include <concino/io/detail/write_hedra.hpp>

namespace concino {

/// Volumes of any polyhedra; no properties.
struct hedra_format {
  static constexpr std::string_view name = "hedra";
  static constexpr std::string_view extensions[] = {".hedra"};
  static constexpr bool holds_surfaces = false, holds_volumes = true;

  template<std::same_as<volume_contents> Contents>  // a template only so that programs that read no volumes need not compile it
  static void read(const read_context& in, Contents& out) { detail::read_hedra(in, out); }
  static void write(write_context& out, flat_mesh& m) { detail::write_hedra(out, m); }
};
static_assert(Format<hedra_format>);

namespace file_format {

inline constexpr hedra_format hedra{};

}  // namespace file_format

/// Reads a mesh from a .hedra file, whatever its extension; no other format is compiled.
/// Needs:  Loadable M, a volume.
/// Result: as load.
/// Cost:   as load.
/// Errors: as load, but for extensions.
template<Loadable M>
M load_hedra(const std::string& path, const load_options& options = {}) {
  return detail::load_with<M>(path, file_format::hedra, options);
}

/// Writes a mesh to a .hedra file, whatever its extension; no other format is compiled.
/// Needs:  a volume mesh with points, of any type.
/// Result: as save.
/// Cost:   as save.
/// Errors: as save, but for extensions.
template<class M>
  requires(AnyMesh<M>&& Embedded<M>)
void save_hedra(const M& m, const std::string& path, const save_options& options = {}) {
  detail::save_with(m, path, file_format::hedra, options);
}

}  // namespace concino
