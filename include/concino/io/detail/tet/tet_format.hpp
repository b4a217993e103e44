// The type of the .tet format. Its reader is defined in read_tet.hpp, its writer in write_tet.hpp.
#pragma once

#include <concino/io/format.hpp>

namespace concino {

/// The .tet format: volumes of tets, hexes, prisms and pyramids, without properties.
struct tet_format {
  static constexpr std::string_view name = "tet";
  static constexpr std::string_view extensions[] = {".tet"};
  static constexpr bool holds_surfaces = false, holds_volumes = true;
  template<std::same_as<volume_contents> Contents>  // a template only so that programs that read no volumes need not
                                                    // compile it
  static void read(const read_context& in, Contents& out);
  static void write(write_context& out, flat_mesh& m);
};
static_assert(Format<tet_format>);

namespace file_format {

inline constexpr tet_format tet{};

}  // namespace file_format

}  // namespace concino
