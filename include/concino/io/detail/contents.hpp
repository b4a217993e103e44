// What readers make of a file, before it becomes a mesh.
#pragma once

#include <concino/core/large_pages.hpp>
#include <concino/core/message.hpp>
#include <concino/core/rgba.hpp>
#include <concino/io/detail/corners.hpp>
#include <concino/io/detail/name_runs.hpp>
#include <concino/io/material_table.hpp>
#include <concino/io/options.hpp>
#include <concino/mesh/arrays.hpp>
#include <concino/mesh/property_set.hpp>

#include <array>
#include <string_view>
#include <type_traits>

namespace concino::detail {

/// What the mesh to be made can hold, so that a reader can point at the line of what it cannot.
struct wanted_mesh {
  bool surface = true;      // it can be made from surface_arrays,
  bool cells = true;        // from cell_arrays,
  bool polyhedra = true;    // from polyhedra_arrays
  std::uint32_t arity = 0;  // verts of every poly where fixed: 3 or 4 for surfaces, 4 or 8 for volumes
};

/// Values that a file gives to elements, in their order; those that it leaves out have the default.
template<class T>
class given_values {
  column values_{values_of<T>};

 public:
  bool empty() const { return values_.size() == 0; }
  std::size_t size() const { return values_.size(); }
  T& operator[](std::size_t i) { return static_cast<T*>(values_.data())[i]; }
  void resize(std::size_t n) { values_.resize(n); }
  void push_back(const T& x) {
    const std::size_t n = size();
    values_.resize(n + 1);
    (*this)[n] = x;
  }
  const column& values() const { return values_; }
};

enum class held_mesh : std::uint8_t { surface, cells, polyhedra };

struct file_contents {
  held_mesh held = held_mesh::surface;
  surface_arrays surface;
  std::vector<int> vert_labels;  // empty, like all that follows, where the file has none
  std::vector<int> poly_labels;
  given_values<rgba> vert_colors;
  given_values<rgba> poly_colors;
  given_values<vec3> vert_normals;
  given_values<std::array<double, 2>> vert_textures;
  name_runs objects, groups, materials;  // of polys
  material_table table;                  // of the materials
};

struct volume_contents : file_contents {
  cell_arrays cells;
  polyhedra_arrays polyhedra;
};

/// Programs that read surfaces only need not compile the rest.
template<bool Volumes>
using contents_of = std::conditional_t<Volumes, volume_contents, file_contents>;

/// What readers are handed.
struct read_context {
  std::string_view text;
  std::string_view name;  // for messages
  wanted_mesh wanted;
  load_report* report;  // never null
  const concino::progress* progress = nullptr;
  bool is_file = false;  // `name` is a path, and there may be more files beside it
};

inline const char* name_of_poly(bool volume, std::uint32_t arity) {
  return volume ? (arity == 4   ? "a tet"
                   : arity == 8 ? "a hex"
                                : "a polyhedron")
                : (arity == 3   ? "a triangle"
                   : arity == 4 ? "a quad"
                                : "a polygon");
}

/// Ends the poly whose corners begin at `first`. While all polys have `arity` corners (0: none has been seen) there are no offsets.
inline void end_poly(surface_arrays& s, std::uint32_t& arity, std::size_t first) {
  const std::size_t size = s.verts.size() - first;
  if (s.offsets.empty()) {
    if (first == 0) arity = static_cast<std::uint32_t>(size);
    if (size == arity) return;
    // the first of another size: from here on every poly says where it begins
    for (std::size_t o = 0; o <= first; o += arity) s.offsets.push_back(static_cast<std::uint32_t>(o));
  }
  s.offsets.push_back(static_cast<std::uint32_t>(s.verts.size()));
}

/// The volume of a file, asked for as a surface, or the reverse. How many polys it holds is told if known.
[[noreturn, gnu::noinline, gnu::cold]] inline void throw_wrong_dimension(std::string_view name, bool holds_volume, std::size_t polys = 0) {
  const std::string of = polys ? core::joined({" of ", polys, holds_volume ? " polyhedra" : " polygons"}) : std::string();
  core::throw_joined<unsupported>({name, ": holds a ", holds_volume ? "volume" : "surface", of, ", but a ", holds_volume ? "surface" : "volume",
                             " mesh was asked for; load it as ", holds_volume ? "polyhedralmesh" : "polygonmesh", " or by load_any"});
}

}  // namespace concino::detail
