// Input and output of the readers of file formats: the text of a file, and the flat arrays from which the mesh is
// constructed.
#pragma once

#include <concino/core/rgba.hpp>
#include <concino/io/detail/cells/repeated_verts.hpp>
#include <concino/io/detail/values/name_runs.hpp>
#include <concino/io/material_table.hpp>
#include <concino/io/options.hpp>
#include <concino/io/text_cursor.hpp>
#include <concino/mesh/arrays.hpp>
#include <concino/mesh/property_set.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace concino {

/// What the type of the mesh can hold, so that a reader can report the line of an element that it cannot hold.
struct wanted_mesh {
  bool surface = true;      // it can be constructed from surface_arrays,
  bool cells = true;        // from cell_arrays,
  bool polyhedra = true;    // from polyhedra_arrays
  std::uint32_t arity = 0;  // number of verts of every poly, if fixed: 3 or 4 for surfaces, 4 or 8 for volumes; else 0
};

/// A value for each element, in the order of the elements. Elements without a value in the file have the default value.
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

/// The values of one property, one for each element of its kind in the order of the file; one value for the mesh as a
/// whole.
struct property_column {
  element_kind kind;
  std::string name;
  std::shared_ptr<detail::column> values;
};

namespace detail {

/// n default values.
inline std::shared_ptr<column> make_column(const value_type& type, std::size_t n) {
  return std::make_shared<column>(type, n);
}

/// Replaces a value that has a copy function. If copying throws, a default value is left.
inline void replace_value(const value_type& type, void* at, const void* from) {
  type.destroy(at);
  try {
    type.copy(at, from);
  } catch (...) {
    type.make(at);
    throw;
  }
}

}  // namespace detail

/// Edges, or faces of a volume, that a file lists by their verts to give them values: element i has verts[offsets[i]]
/// .. verts[offsets[i+1]-1]. The elements of the mesh are found by their verts, in any order.
struct listed_elements {
  std::vector<std::uint32_t> offsets{0};
  std::vector<vert_id> verts;

  std::size_t size() const { return offsets.size() - 1; }
  /// Adds an element with the verts that were added since the last one.
  void end_element() { offsets.push_back(static_cast<std::uint32_t>(verts.size())); }
};

/// Which of the arrays a reader has filled.
enum class arrays_kind : std::uint8_t { surface, cells, polyhedra };

/// The contents of a file that holds a surface: its arrays, and the values of its elements. Readers fill it in the
/// order of the file. Unused arrays stay empty.
struct file_contents {
  arrays_kind filled = arrays_kind::surface;
  surface_arrays surface;
  std::vector<int> vert_labels;  // empty if the file has none, like all the members below
  std::vector<int> poly_labels;
  element_values<rgba> vert_colors;
  element_values<rgba> poly_colors;
  element_values<vec3> vert_normals;
  element_values<std::array<double, 2>> vert_textures;
  detail::name_runs objects, groups, materials;  // of polys
  material_table table;                          // of the materials

  /// Properties with any names and types. The values of a kind are in the order of the file: those of corners follow
  /// surface.verts, those of edges and faces belong to the elements listed below. A second one with the same kind and
  /// name, or with the name of a member above, becomes a property with another name, such as "heat_2".
  std::vector<property_column> properties;
  listed_elements edges, faces;
  bool lists_all_faces = false;  // the values of faces are those of the faces of `polyhedra` in order, and `faces` is
                                 // empty
  detail::polys_with_repeats repeated;  // with the policy of load_options::repeated_verts, which cell_builder and load
                                        // follow

  /// Adds a property with n default values.
  /// Result: where to store the n values; valid as long as the contents.
  void* add_property(element_kind kind, std::string_view property, const detail::value_type& type, std::size_t n) {
    properties.push_back({kind, std::string(property), detail::make_column(type, n)});
    return properties.back().values->data();
  }
  template<class T>
  T* add_property(element_kind kind, std::string_view property, std::size_t n) {
    return static_cast<T*>(add_property(kind, property, detail::values_of<T>, n));
  }
};

/// The contents of a file that holds a surface or a volume: `filled` says which arrays are used.
struct volume_contents : file_contents {
  cell_arrays cells;
  polyhedra_arrays polyhedra;
};

/// The input of a reader. The text is the whole file, and stays in place while it is read.
struct read_context {
  std::string_view text;
  std::string_view name;  // for messages; the path, if there is one
  wanted_mesh wanted;
  load_report* report;  // never null
  const concino::progress* progress = nullptr;  // for text_cursor
  bool is_file = false;                         // `name` is a path, and the same folder may contain more files to read
  inflate_function inflate = nullptr;           // load_options::inflate
  concino::repeated_verts repeated_verts = concino::repeated_verts::refuse;  // load_options::repeated_verts
  bool corners_only = false;                    // load_options::corners_only

  /// A cursor over the words of the text. `comment`, unless 0, begins a comment that ends with its line.
  token_cursor words(char comment = 0) const { return {text, name, progress, comment}; }
};

}  // namespace concino
