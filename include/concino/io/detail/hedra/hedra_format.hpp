// The type of the .hedra format. Its reader is defined in read_hedra.hpp, its writer in write_hedra.hpp.
#pragma once

#include <concino/io/format.hpp>

namespace concino {

/// The .hedra format: volumes of any polyhedra, without properties.
struct hedra_format {
  static constexpr std::string_view name = "hedra";
  static constexpr std::string_view extensions[] = {".hedra"};
  static constexpr bool holds_surfaces = false, holds_volumes = true;
  static constexpr bool holds_faces = true;
  template<std::same_as<volume_contents> Contents>  // a template only so that programs that read no volumes need not
                                                    // compile it
  static void read(const read_context& in, Contents& out);
  static void write(write_context& out, flat_mesh& m);
};
static_assert(Format<hedra_format>);

namespace file_format {

inline constexpr hedra_format hedra{};

}  // namespace file_format

}  // namespace concino
