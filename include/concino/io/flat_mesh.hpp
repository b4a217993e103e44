// A mesh as writers see it: flat arrays, with elements numbered from 0 as they come in the file.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/core/vec3.hpp>
#include <concino/mesh/property_set.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace concino {

/// Lists one after another in memory. List i is values[offsets[i]] .. values[offsets[i+1]-1], or, where all have `arity` > 0 values,
/// values[i*arity] .. values[(i+1)*arity-1].
template<class T>
struct flat_lists {
  std::span<const T> values;
  std::span<const std::size_t> offsets;  // empty with an arity
  std::size_t arity = 0;

  std::size_t size() const { return arity ? values.size() / arity : offsets.empty() ? 0 : offsets.size() - 1; }
  std::span<const T> operator[](std::size_t i) const {
    return arity ? values.subspan(i * arity, arity) : values.subspan(offsets[i], offsets[i + 1] - offsets[i]);
  }
};

/// A property of the verts or polys of a mesh by their numbers; false where the mesh has none of that name and type.
template<class T>
struct flat_values {
  const T* values = nullptr;
  const std::uint32_t* indices = nullptr;  // of elements in the mesh, by their numbers; null: the same

  explicit operator bool() const { return values != nullptr; }
  const T& operator[](std::size_t i) const { return values[indices ? indices[i] : i]; }
};

/// Faces as lists of verts, polys as lists of faces; outward[k] says whether the face poly_faces.values[k], walked as listed, runs
/// counter-clockwise seen from outside the poly.
struct flat_polyhedra {
  flat_lists<vert_id> face_verts;
  flat_lists<face_id> poly_faces;
  std::span<const std::uint8_t> outward;
};

/// What writers are handed of a mesh. Arrays that lie so in the mesh, as in those of the library while nothing has been removed from them, are
/// shown where they are; others are copies.
class flat_mesh {
 public:
  int dimension = 2;                                 // 2: a surface; 3: a volume
  std::uint32_t arity = 0;                           // verts of every poly where the type of the mesh fixes it, else 0
  std::size_t num_polys = 0;
  std::span<const vec3> points;                      // of the verts; all finite
  flat_lists<vert_id> poly_verts;                    // of surfaces, in cyclic order; of tets and hexes, in the standard order; else empty
  const property_set* properties = nullptr;          // null where the mesh can have none
  std::span<const std::uint32_t> vert_indices = {};  // in the mesh, by number; empty where they are the numbers
  std::span<const std::uint32_t> poly_indices = {};

  /// Of volumes.      Cost: the first call of a mesh of tets or hexes makes these lists.
  const flat_polyhedra& polyhedra() {
    if (!has_polyhedra_) make_polyhedra();
    has_polyhedra_ = true;
    return polyhedra_;
  }

  /// The index that the mesh itself gives to a vert or poly, for messages.
  std::size_t vert_index(std::size_t i) const { return vert_indices.empty() ? i : vert_indices[i]; }
  std::size_t poly_index(std::size_t i) const { return poly_indices.empty() ? i : poly_indices[i]; }

  /// The property of that name if it has values of type T. Say what the file keeps by write_context::keep.
  template<class T>
  flat_values<T> vert_values(std::string_view name) const {
    return {values<T>(element_kind::vert, name), vert_indices.empty() ? nullptr : vert_indices.data()};
  }
  template<class T>
  flat_values<T> poly_values(std::string_view name) const {
    return {values<T>(element_kind::poly, name), poly_indices.empty() ? nullptr : poly_indices.data()};
  }
  /// The same of the mesh as a whole; null where there is none.
  template<class T>
  const T* mesh_value(std::string_view name) const { return values<T>(element_kind::mesh, name); }

 protected:
  flat_mesh() = default;
  flat_mesh(const flat_mesh&) = delete;
  flat_mesh& operator=(const flat_mesh&) = delete;
  ~flat_mesh() = default;

  flat_polyhedra polyhedra_;

 private:
  virtual void make_polyhedra() = 0;
  bool has_polyhedra_ = false;

  template<class T>
  const T* values(element_kind kind, std::string_view name) const {
    return properties ? static_cast<const T*>(properties->values_if_any(kind, name, typeid(T))) : nullptr;
  }
};

}  // namespace concino
