// What readers make of a file, before it becomes a mesh.
#pragma once

#include <concino/io/message.hpp>
#include <concino/io/options.hpp>
#include <concino/mesh/arrays.hpp>

#include <string_view>
#include <variant>

namespace concino::detail {

/// What the mesh to be made can hold, so that a reader can point at the line of what it cannot.
struct wanted_mesh {
  bool surface = true;     // it can be made from surface_arrays,
  bool cells = true;       // from cell_arrays,
  bool polyhedra = true;   // from polyhedra_arrays
  std::uint32_t arity = 0;  // verts of every poly where fixed: 3 or 4 for surfaces, 4 or 8 for volumes
};

struct file_contents {
  std::variant<surface_arrays, cell_arrays, polyhedra_arrays> arrays;
  std::vector<int> vert_labels;  // empty where the file has none but zeros
  std::vector<int> poly_labels;
};

/// What readers are handed.
struct read_context {
  std::string_view text;
  std::string_view name;  // for messages
  wanted_mesh wanted;
  load_report* report;  // never null
  const concino::progress* progress = nullptr;
};

inline const char* name_of_poly(bool volume, std::uint32_t arity) {
  return volume ? (arity == 4   ? "a tet"
                   : arity == 8 ? "a hex"
                                : "a polyhedron")
                : (arity == 3   ? "a triangle"
                   : arity == 4 ? "a quad"
                                : "a polygon");
}

/// The volume of a file, asked for as a surface, or the reverse. How many polys it holds is told if known.
[[noreturn, gnu::noinline, gnu::cold]] inline void throw_wrong_dimension(std::string_view name, bool holds_volume, std::size_t polys = 0) {
  const std::string of = polys ? joined({" of ", polys, holds_volume ? " polyhedra" : " polygons"}) : std::string();
  throw_joined<unsupported>({name, ": holds a ", holds_volume ? "volume" : "surface", of, ", but a ", holds_volume ? "surface" : "volume",
                             " mesh was asked for; load it as ", holds_volume ? "polyhedralmesh" : "polygonmesh", " or by load_any"});
}

}  // namespace concino::detail
