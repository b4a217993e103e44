// The types of TetGen's two formats of surfaces, .smesh and .poly. Their readers are defined in read_smesh.hpp, their
// writers in write_smesh.hpp.
#pragma once

#include <concino/io/format.hpp>

namespace concino {

/// TetGen's simple format of surfaces: points, and facets of one polygon each; "label" of verts and polys,
/// "attribute_1", "attribute_2", ... (double) of verts.
struct smesh_format {
  static constexpr std::string_view name = "smesh";
  static constexpr std::string_view extensions[] = {".smesh"};
  static constexpr bool holds_surfaces = true, holds_volumes = false;
  static void read(const read_context& in, file_contents& out);
  static void write(write_context& out, flat_mesh& m);
};
static_assert(Format<smesh_format>);

/// TetGen's other format of surfaces, in which a facet may have several polygons; with the same properties.
struct poly_format {
  static constexpr std::string_view name = "poly";
  static constexpr std::string_view extensions[] = {".poly"};
  static constexpr bool holds_surfaces = true, holds_volumes = false;
  static void read(const read_context& in, file_contents& out);
  static void write(write_context& out, flat_mesh& m);
};
static_assert(Format<poly_format>);

namespace file_format {

inline constexpr smesh_format smesh{};
inline constexpr poly_format poly{};

}  // namespace file_format

}  // namespace concino
