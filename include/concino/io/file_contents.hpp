// What readers are handed, and what they make of a file before it becomes a mesh: flat arrays, which the mesh takes over.
#pragma once

#include <concino/core/rgba.hpp>
#include <concino/io/detail/name_runs.hpp>
#include <concino/io/material_table.hpp>
#include <concino/io/options.hpp>
#include <concino/io/text_cursor.hpp>
#include <concino/mesh/arrays.hpp>
#include <concino/mesh/property_set.hpp>

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace concino {

/// What the mesh to be made can hold, so that a reader can point at the line of what it cannot.
struct wanted_mesh {
  bool surface = true;      // it can be made from surface_arrays,
  bool cells = true;        // from cell_arrays,
  bool polyhedra = true;    // from polyhedra_arrays
  std::uint32_t arity = 0;  // verts of every poly where fixed: 3 or 4 for surfaces, 4 or 8 for volumes
};

/// Values that a file gives to elements, in their order; those that it leaves out have the default.
template<class T>
class element_values {
  detail::column values_{detail::values_of<T>};

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
  const detail::column& values() const { return values_; }
};

/// Which of the arrays a reader has filled.
enum class arrays_kind : std::uint8_t { surface, cells, polyhedra };

/// A surface, and what a file says of its elements. Readers of surfaces fill this, in the order of the file; what they need not is empty.
struct file_contents {
  arrays_kind filled = arrays_kind::surface;
  surface_arrays surface;
  std::vector<int> vert_labels;  // empty, like all that follows, where the file has none
  std::vector<int> poly_labels;
  element_values<rgba> vert_colors;
  element_values<rgba> poly_colors;
  element_values<vec3> vert_normals;
  element_values<std::array<double, 2>> vert_textures;
  detail::name_runs objects, groups, materials;  // of polys
  material_table table;                          // of the materials
};

/// The same for a mesh of any dimension: `held` says which arrays count.
struct volume_contents : file_contents {
  cell_arrays cells;
  polyhedra_arrays polyhedra;
};

/// What readers are handed. The text is the whole file; it stays where it is while it is read.
struct read_context {
  std::string_view text;
  std::string_view name;  // for messages; the path, if there is one
  wanted_mesh wanted;
  load_report* report;  // never null
  const concino::progress* progress = nullptr;  // for text_cursor
  bool is_file = false;                         // `name` is a path, and there may be more files beside it

  /// The text as words; `comment` begins a comment to the end of its line, if it is not 0.
  token_cursor words(char comment = 0) const { return {text, name, progress, comment}; }
};

}  // namespace concino
