// The type of the .hybrid format. Its reader is defined in read_hybrid.hpp, its writer in write_hybrid.hpp.
#pragma once

#include <concino/io/format.hpp>

namespace concino {

/// The .hybrid format: volumes of any polyhedra, without properties.
struct hybrid_format {
  static constexpr std::string_view name = "hybrid";
  static constexpr std::string_view extensions[] = {".hybrid"};
  static constexpr bool holds_surfaces = false, holds_volumes = true;
  static constexpr bool holds_faces = true;
  template<std::same_as<volume_contents> Contents>  // a template only so that programs that read no volumes need not
                                                    // compile it
  static void read(const read_context& in, Contents& out);
  static void write(write_context& out, flat_mesh& m);
};
static_assert(Format<hybrid_format>);

namespace file_format {

inline constexpr hybrid_format hybrid{};

}  // namespace file_format

}  // namespace concino
