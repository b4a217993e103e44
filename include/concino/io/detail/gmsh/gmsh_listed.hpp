// The elements of a mesh that a Gmsh file lists: all polys, and the faces, edges and verts that have values.
#pragma once

#include <concino/io/detail/cells/recognised_cells.hpp>
#include <concino/io/detail/gmsh/gmsh_tags.hpp>
#include <concino/io/detail/gmsh/gmsh_types.hpp>
#include <concino/io/detail/vtk/vtk_numbers.hpp>

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace concino::detail {

/// A property that is written as real numbers.
struct gmsh_property {
  element_kind kind;
  std::string name;
  vtk_property_type type;
  flat_values<unsigned char> values;  // bytes
  std::size_t bytes;                  // of one value

  const unsigned char* at(std::size_t i) const {
    return values.values + (values.indices ? values.indices[i] : i) * bytes;
  }
  bool has_value(std::size_t i) const {
    return std::any_of(at(i), at(i) + bytes, [](unsigned char b) { return b != 0; });
  }
  /// Calls f(number) for each number of an element.
  template<class F>
  void for_each_number(std::size_t i, const F& f) const {
    const std::size_t size = vtk_names_of(type.number).size;
    for (std::size_t k = 0; k < type.components; ++k)
      with_number_type(type.number, [&]<class T>(std::type_identity<T>) {
        T x;
        std::memcpy(&x, at(i) + k * size, sizeof x);
        f(static_cast<double>(x));
      });
  }
};

/// Elements of one kind, in the order of the file.
struct gmsh_listed {
  element_kind kind;
  int dimension = 0;
  flat_values<int> label = {}, entity_tag = {}, entity = {};
  std::vector<std::uint32_t> elements = {};  // their numbers in the mesh
  std::vector<gmsh_shape> shapes = {};
  std::vector<vert_id> verts = {};

  gmsh_entity_key key(std::size_t i) const {
    const std::uint32_t e = elements[i];
    return {entity_tag ? entity_tag[e] : 0, label ? label[e] : 0};
  }
  bool is_marked(std::size_t e) const {
    return (label && label[e] != 0) || (entity_tag && entity_tag[e] != 0) || (entity && entity[e] != 0);
  }
  void add(std::size_t e, gmsh_shape shape, const vert_id* v, std::size_t n) {
    elements.push_back(static_cast<std::uint32_t>(e));
    shapes.push_back(shape);
    verts.insert(verts.end(), v, v + n);
  }
};

/// Finds all elements to list. Needs: collect() first.
class gmsh_lists {
  write_context& c_;
  flat_mesh& m_;

  bool has_value(const gmsh_listed& to, std::size_t e) const {
    return to.is_marked(e) || std::any_of(properties.begin(), properties.end(),
                                          [&](const gmsh_property& p) { return p.kind == to.kind && p.has_value(e); });
  }

  void collect_polys() {
    gmsh_listed& to = of_polys;
    if (m_.dimension == 3) {
      for_each_cell(m_, [&](std::size_t p, cell_shape s, const vert_id* v) {
        if (s == cell_shape::general) throw_general_cell(c_, m_, p, ".msh");
        to.add(p, static_cast<gmsh_shape>(static_cast<int>(gmsh_shape::tet) + static_cast<int>(s)), v,
               standard_cell_of(s).num_verts);
      });
      return;
    }
    for (std::size_t p = 0; p < m_.num_polys; ++p) {
      const std::span<const vert_id> v = m_.poly_verts[p];
      if (v.size() != 3 && v.size() != 4)
        c_.throw_cannot_hold(".msh", {"poly ", m_.poly_index(p), ", a polygon of ", v.size(), " verts"},
                             ".obj, .ply or .vtu");
      to.add(p, v.size() == 3 ? gmsh_shape::triangle : gmsh_shape::quad, v.data(), v.size());
    }
  }

  /// Faces and edges are sorted by their verts, so that the file does not depend on how the mesh stores them.
  template<class Verts>
  void collect_sorted(gmsh_listed& to, std::size_t n, const Verts& verts_of) {
    std::vector<std::pair<std::vector<vert_id>, std::uint32_t>> cycles;
    for (std::size_t e = 0; e < n; ++e) {
      if (!has_value(to, e)) continue;
      std::vector<vert_id> v = verts_of(e);
      rotate_to_smallest(v.data(), v.size());
      if (v.back() < v[1]) std::reverse(v.begin() + 1, v.end());
      if (v.size() > 4) ++num_large_faces;
      else cycles.emplace_back(std::move(v), static_cast<std::uint32_t>(e));
    }
    std::sort(cycles.begin(), cycles.end());
    constexpr gmsh_shape shapes[] = {gmsh_shape::line, gmsh_shape::triangle, gmsh_shape::quad};
    for (const auto& [v, e] : cycles) to.add(e, shapes[v.size() - 2], v.data(), v.size());
  }

  /// Whether the mesh has properties of these elements.
  bool needs(const gmsh_listed& l) const {
    return l.label || l.entity_tag || l.entity ||
           std::any_of(properties.begin(), properties.end(), [&](const gmsh_property& p) { return p.kind == l.kind; });
  }

 public:
  gmsh_listed of_polys{element_kind::poly}, of_faces{element_kind::face, 2}, of_edges{element_kind::edge, 1},
      of_verts{element_kind::vert, 0};
  std::vector<gmsh_property> properties;
  std::uint64_t num_large_faces = 0;  // faces of more than four verts that have a value

  gmsh_lists(write_context& c, flat_mesh& m) : c_(c), m_(m) { of_polys.dimension = m.dimension; }

  void collect() {
    of_polys.label = m_.poly_values<int>("label");
    of_polys.entity_tag = m_.poly_values<int>("entity_tag");
    of_verts.label = m_.vert_values<int>("label");
    of_verts.entity_tag = m_.vert_values<int>("entity_tag");
    of_verts.entity = m_.vert_values<int>("entity");
    of_edges.label = m_.edge_values<int>("label");
    of_edges.entity_tag = m_.edge_values<int>("entity_tag");
    of_edges.entity = m_.edge_values<int>("entity");
    of_faces.label = m_.face_values<int>("label");
    of_faces.entity_tag = m_.face_values<int>("entity_tag");
    of_faces.entity = m_.face_values<int>("entity");
    collect_polys();
    if (needs(of_faces))
      collect_sorted(of_faces, m_.polyhedra().face_verts.size(), [&](std::size_t f) {
        const std::span<const vert_id> v = m_.polyhedra().face_verts[f];
        return std::vector<vert_id>(v.begin(), v.end());
      });
    if (needs(of_edges))
      collect_sorted(of_edges, m_.edge_verts().size(), [&](std::size_t e) {
        const std::array<vert_id, 2>& v = m_.edge_verts()[e];
        return std::vector<vert_id>(v.begin(), v.end());
      });
    for (std::size_t v = 0; v < m_.points.size(); ++v) {
      const vert_id id{static_cast<std::uint32_t>(v)};
      if (of_verts.is_marked(v)) of_verts.add(v, gmsh_shape::point, &id, 1);
    }
  }
};

}  // namespace concino::detail
