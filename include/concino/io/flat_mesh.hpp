// A mesh as flat arrays, for writers. Elements are numbered from 0 in the order of the file.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/core/vec3.hpp>
#include <concino/mesh/property_set.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace concino {

/// Lists stored one after another. List i is values[offsets[i]] .. values[offsets[i+1]-1]. If all lists have `arity` >
/// 0 values, it is values[i*arity] .. values[(i+1)*arity-1].
template<class T>
struct flat_lists {
  std::span<const T> values;
  std::span<const std::size_t> offsets;  // empty if arity > 0
  std::size_t arity = 0;

  std::size_t size() const { return arity ? values.size() / arity : offsets.empty() ? 0 : offsets.size() - 1; }
  std::span<const T> operator[](std::size_t i) const {
    return arity ? values.subspan(i * arity, arity) : values.subspan(offsets[i], offsets[i + 1] - offsets[i]);
  }
};

/// The values of a property of verts or polys, by the number of the element. Converts to false if the mesh has no such
/// property.
template<class T>
struct flat_values {
  const T* values = nullptr;
  const std::uint32_t* indices = nullptr;  // the index in the mesh of each number; null: index and number are equal

  explicit operator bool() const { return values != nullptr; }
  const T& operator[](std::size_t i) const { return values[indices ? indices[i] : i]; }
};

/// A property of the mesh, for writers that store properties of any name.
struct flat_property {
  element_kind kind;  // vert, face, poly or mesh
  std::string name;
  const std::type_info* type;
  const void* values;
  const std::uint32_t* indices;  // as in flat_values

  /// The values, if they have type T; else a flat_values that converts to false.
  template<class T>
  flat_values<T> as() const { return {*type == typeid(T) ? static_cast<const T*>(values) : nullptr, indices}; }
};

/// Polyhedra as arrays: faces are lists of verts, polys are lists of faces. outward[k] says whether the verts of face
/// poly_faces.values[k], in the order listed, are counter-clockwise as seen from outside the poly.
struct flat_polyhedra {
  flat_lists<vert_id> face_verts;
  flat_lists<face_id> poly_faces;
  std::span<const std::uint8_t> outward;
};

/// The input of a writer: a mesh as flat arrays. If the mesh stores an array in this form, the span refers to it;
/// otherwise to a copy. Native meshes do so as long as nothing has been removed from them.
class flat_mesh {
 public:
  int dimension = 2;                                 // 2: a surface; 3: a volume
  std::uint32_t arity = 0;                           // number of verts of every poly if the type of the mesh fixes it,
                                                     // else 0
  std::size_t num_polys = 0;
  std::span<const vec3> points;                      // of the verts; all finite
  flat_lists<vert_id> poly_verts;                    // surfaces: in cyclic order; tets and hexes: in the standard
                                                     // order; else empty
  const property_set* properties = nullptr;          // null if the type of the mesh has none
  std::span<const std::uint32_t> vert_indices = {};  // the index in the mesh of each number; empty if they are equal
  std::span<const std::uint32_t> poly_indices = {};
  std::span<const std::uint32_t> face_indices = {};  // of the faces of polyhedra(), once it was called

  /// The faces and polyhedra of a volume.      Cost: the first call builds these lists for a mesh of tets or hexes.
  const flat_polyhedra& polyhedra() {
    if (!has_polyhedra_) make_polyhedra();
    has_polyhedra_ = true;
    return polyhedra_;
  }

  /// The two verts of each edge.      Cost: the first call builds this list.
  std::span<const std::array<vert_id, 2>> edge_verts() {
    if (!has_edges_) make_edges();
    has_edges_ = true;
    return edge_verts_;
  }

  /// The number of edges of a surface without polys, and of a volume without faces, which no file holds.      Cost:
  /// O(edges); native meshes have none.
  virtual std::size_t num_loose_edges() const { return 0; }

  /// The index of a vert or poly in the mesh, for messages.
  std::size_t vert_index(std::size_t i) const { return vert_indices.empty() ? i : vert_indices[i]; }
  std::size_t poly_index(std::size_t i) const { return poly_indices.empty() ? i : poly_indices[i]; }

  /// The property of that name if it has values of type T. A writer that stores it calls write_context::declare_stored.
  template<class T>
  flat_values<T> vert_values(std::string_view name) const {
    return {values<T>(element_kind::vert, name), vert_indices.empty() ? nullptr : vert_indices.data()};
  }
  template<class T>
  flat_values<T> poly_values(std::string_view name) const {
    return {values<T>(element_kind::poly, name), poly_indices.empty() ? nullptr : poly_indices.data()};
  }
  /// The same for edges, by their numbers in edge_verts(), and for faces, by their numbers in polyhedra().      Cost:
  /// O(edges), O(faces).
  template<class T>
  flat_values<T> edge_values(std::string_view name) {
    const T* const found = values<T>(element_kind::edge, name);
    if (found) edge_verts();
    return {found, edge_indices_.empty() ? nullptr : edge_indices_.data()};
  }
  template<class T>
  flat_values<T> face_values(std::string_view name) {
    const T* const found = dimension == 3 ? values<T>(element_kind::face, name) : nullptr;
    if (found) polyhedra();
    return {found, face_indices.empty() ? nullptr : face_indices.data()};
  }
  /// The same for the corners of a surface, in the order of poly_verts.values.      Cost: O(corners).
  template<class T>
  flat_values<T> corner_values(std::string_view name) {
    const T* const found = dimension == 2 ? values<T>(element_kind::corner, name) : nullptr;
    if (found && !has_corners_) make_corners();
    has_corners_ = has_corners_ || found;
    return {found, corner_indices_.empty() ? nullptr : corner_indices_.data()};
  }
  /// All properties of verts, faces, polys and the mesh as a whole, in the order in which they were created. A writer
  /// passes those that it stores to write_context::declare_stored.      Cost: calls polyhedra() if there is a property
  /// of faces.
  std::vector<flat_property> property_list();
  /// The same of edges.      Cost: calls edge_verts() if there is one.
  std::vector<flat_property> edge_property_list();
  /// The value of a property of the mesh as a whole; null if there is none.
  template<class T>
  const T* mesh_value(std::string_view name) const { return values<T>(element_kind::mesh, name); }

 protected:
  flat_mesh() = default;
  flat_mesh(const flat_mesh&) = delete;
  flat_mesh& operator=(const flat_mesh&) = delete;
  ~flat_mesh() = default;

  flat_polyhedra polyhedra_;
  std::vector<std::array<vert_id, 2>> edge_verts_;
  std::vector<std::uint32_t> edge_indices_, corner_indices_;  // the index in the mesh of each number; empty if they are
                                                              // equal

 private:
  virtual void make_polyhedra() = 0;
  virtual void make_edges() = 0;
  virtual void make_corners() = 0;
  bool has_polyhedra_ = false, has_edges_ = false, has_corners_ = false;

  template<class T>
  const T* values(element_kind kind, std::string_view name) const {
    return properties ? static_cast<const T*>(properties->values_if_any(kind, name, typeid(T))) : nullptr;
  }
};

inline std::vector<flat_property> flat_mesh::property_list() {
  std::vector<flat_property> list;
  for (std::size_t i = 0; properties && i < properties->size(); ++i) {
    const property_info p = properties->info(i);
    if (p.kind == element_kind::edge || p.kind == element_kind::corner ||
        (p.kind == element_kind::face && dimension != 3))
      continue;
    if (p.kind == element_kind::face) polyhedra();
    std::span<const std::uint32_t> indices;
    if (p.kind == element_kind::vert) indices = vert_indices;
    if (p.kind == element_kind::face) indices = face_indices;
    if (p.kind == element_kind::poly) indices = poly_indices;
    list.push_back({p.kind, p.name, p.type, properties->values_if_any(p.kind, p.name, *p.type),
                    indices.empty() ? nullptr : indices.data()});
  }
  return list;
}

inline std::vector<flat_property> flat_mesh::edge_property_list() {
  std::vector<flat_property> list;
  for (std::size_t i = 0; properties && i < properties->size(); ++i) {
    const property_info p = properties->info(i);
    if (p.kind != element_kind::edge) continue;
    edge_verts();
    list.push_back({p.kind, p.name, p.type, properties->values_if_any(p.kind, p.name, *p.type),
                    edge_indices_.empty() ? nullptr : edge_indices_.data()});
  }
  return list;
}

}  // namespace concino
