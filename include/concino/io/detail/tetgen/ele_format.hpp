// The type of TetGen's format of volumes, .node and .ele. Its reader is defined in read_ele.hpp, its writer in
// write_ele.hpp.
#pragma once

#include <concino/io/format.hpp>

namespace concino {

/// TetGen's format of volumes of tets: x.node lists points, x.ele tets, x.face and x.edge faces and edges with markers;
/// "label" of all elements, "attribute_1", "attribute_2", ... (double) of verts and polys.
struct ele_format {
  static constexpr std::string_view name = "ele";
  static constexpr std::string_view extensions[] = {".ele", ".node"};
  static constexpr bool holds_surfaces = false, holds_volumes = true;
  template<std::same_as<volume_contents> Contents>  // a template only so that programs that read no volumes need not
                                                    // compile it
  static void read(const read_context& in, Contents& out);
  static void write(write_context& out, flat_mesh& m);
};
static_assert(Format<ele_format>);

namespace file_format {

inline constexpr ele_format ele{};

}  // namespace file_format

}  // namespace concino
