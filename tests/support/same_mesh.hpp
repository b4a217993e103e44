// Compares meshes element by element, with their properties.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/io/detail/vtk/vtk_numbers.hpp>
#include <concino/io/material_table.hpp>
#include <concino/mesh/corner_property.hpp>
#include <concino/mesh/property.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace concino::testing {

/// The values of a property as bytes, in the order of the indices; "?" if no file can hold values of this type.
template<class M>
std::string bytes_of_property(const M& m, const property_info& p) {
  const void* const values = traits<M>::properties(m).values_if_any(p.kind, p.name, *p.type);
  std::size_t bound = 1;
  if (p.kind == element_kind::vert) bound = vert_index_bound(m);
  if (p.kind == element_kind::edge) bound = edge_index_bound(m);
  if (p.kind == element_kind::poly) bound = poly_index_bound(m);
  if constexpr (dimension_v<M> == 3)  // surfaces have no faces
    if (p.kind == element_kind::face) bound = face_index_bound(m);
  if (p.kind == element_kind::corner) bound = traits<M>::corner_index_bound(m);
  std::string bytes;
  if (*p.type == typeid(std::string)) {
    for (std::size_t i = 0; i < bound; ++i) (bytes += static_cast<const std::string*>(values)[i]) += '\0';
  } else if (*p.type == typeid(material_table)) {
    for (const material& a : static_cast<const material_table*>(values)->materials) {
      (bytes += a.name) += '\0';
      for (const std::string& line : a.lines) (bytes += line) += '\n';
    }
  } else if (const concino::detail::vtk_property_type type = concino::detail::vtk_type_of(*p.type); type.number != concino::detail::vtk_number::none) {
    bytes.assign(static_cast<const char*>(values), bound * type.components * concino::detail::vtk_names_of(type.number).size);
  } else {
    bytes = "?";
  }
  return bytes;
}

/// A mesh as numbers and texts. Meshes with equal records have the same points to the last bit, the same elements in the same order, and properties
/// of the same names, types and values.
struct mesh_record {
  std::string points;                     // as bytes
  std::vector<std::uint32_t> elements;    // of each poly: its faces and how they are turned, or its verts; then of each face: its verts
  std::vector<std::string> properties, values;

  friend bool operator==(const mesh_record&, const mesh_record&) = default;
};

template<class M>
mesh_record record_of(const M& m) {
  mesh_record r;
  r.points.reserve(num_verts(m) * sizeof(vec3));
  for (const auto v : verts(m)) r.points.append(reinterpret_cast<const char*>(&point(m, v)), sizeof(vec3));
  const auto add = [&](const auto& list) {
    std::uint32_t n = 0;
    for (const auto x : list) r.elements.push_back(static_cast<std::uint32_t>(index_of(m, x))), ++n;
    r.elements.push_back(n);
  };
  for (const auto p : polys(m)) {
    if constexpr (dimension_v<M> == 2 || arity_v<M> != 0) {  // polyhedra are lists of faces
      add(adj_p2v(m, p));
    } else {
      add(adj_p2f(m, p));
      for (const auto f : adj_p2f(m, p)) r.elements.push_back(face_is_outward(m, p, f) ? 1 : 0);
    }
  }
  if constexpr (dimension_v<M> == 3 && arity_v<M> == 0)  // those of other meshes follow from their polys
    for (const auto f : faces(m)) add(adj_f2v(m, f));
  for (const property_info& p : property_list(m)) {
    r.properties.push_back(core::joined({to_string(p.kind), " ", p.name, " ", p.type->name()}));
    r.values.push_back(bytes_of_property(m, p));
  }
  return r;
}

}  // namespace concino::testing
