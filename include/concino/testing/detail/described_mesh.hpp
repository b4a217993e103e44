// All that rewire may change of a mesh, in a form that can be compared: descriptors, points, corners, and values of
// named properties.
#pragma once

#include <concino/concepts/editable.hpp>
#include <concino/core/vec3.hpp>
#include <concino/mesh/property.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace concino::testing::detail {

/// The verts of a poly by index: one list, or, of a general polyhedron, one for each face, counter-clockwise seen from
/// outside.
using poly_shape = std::vector<std::vector<std::size_t>>;

/// General polyhedra have no order of verts; their corners are those of faces.
template<class M> inline constexpr bool has_general_polyhedra = dimension_v<M> == 3 && arity_v<M> == 0;

/// Cycles start anywhere, and faces come in any order. The lists of tets and hexes have a fixed order.
template<class M>
poly_shape in_normal_form(poly_shape shape) {
  if constexpr (dimension_v<M> == 3 && arity_v<M> != 0) return shape;  // not cycles
  for (auto& cycle : shape) std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
  std::sort(shape.begin(), shape.end());
  return shape;
}

template<AnyMesh M>
std::vector<std::size_t> indices_of_verts(const M& m, const auto& range) {
  std::vector<std::size_t> all;
  for (const vert_t<M> v : range) all.push_back(index_of(m, v));
  return all;
}

template<AnyMesh M>
poly_shape described_shape(const M& m, const poly_t<M>& p) {
  poly_shape shape;
  if constexpr (has_general_polyhedra<M>) {
    for (const face_t<M> f : adj_p2f(m, p)) {
      shape.push_back(indices_of_verts(m, adj_f2v(m, f)));
      if (!face_is_outward(m, p, f)) std::reverse(shape.back().begin(), shape.back().end());
    }
  } else {
    shape.push_back(indices_of_verts(m, adj_p2v(m, p)));
  }
  return in_normal_form<M>(std::move(shape));
}

template<class M>
struct described_mesh {
  struct vert_entry {
    vert_t<M> vert;
    vec3 point;
    bool is_new = false;
    double value = 0;
  };
  struct poly_entry {
    poly_t<M> poly;
    poly_shape shape;
    bool is_new = false;
    double value = 0;
  };
  /// An edge or face; `count` is how many have the same verts.
  template<class X>
  struct lower_entry {
    X element;
    std::size_t index, count;
  };
  template<class Y> struct face_map {};
  template<class Y>
    requires requires { typename face_t<Y>; }
  struct face_map<Y> : std::map<std::vector<std::size_t>, lower_entry<face_t<Y>>> {};

  std::map<std::size_t, vert_entry> verts;
  std::map<std::size_t, poly_entry> polys;
  std::map<std::vector<std::size_t>, lower_entry<edge_t<M>>> edges;  // by their verts; those with polys
  face_map<M> faces;
};

inline constexpr const char* label_name = "concino::conformance";

/// Gives each vert and poly a value of a named property, if the mesh has properties.
template<class M>
void label_elements([[maybe_unused]] M& m) {
  if constexpr (HasProperties<M>) {
    auto of_verts = vert_property<double>(m, label_name);
    auto of_polys = poly_property<double>(m, label_name);
    for (const vert_t<M> v : verts(m)) of_verts[v] = 1 + static_cast<double>(index_of(m, v));
    for (const poly_t<M> p : polys(m)) of_polys[p] = 1 + static_cast<double>(index_of(m, p));
  }
}

template<class X, class Map, class M>
void describe_lower(const M& m, const X& x, const auto& verts, Map& to) {
  std::vector<std::size_t> key = indices_of_verts(m, verts);
  std::sort(key.begin(), key.end());
  ++to.try_emplace(std::move(key), typename Map::mapped_type{x, index_of(m, x), 0}).first->second.count;
}

template<EditableMesh M>
described_mesh<M> describe(const M& m) {
  described_mesh<M> d;
  for (const vert_t<M> v : verts(m)) d.verts[index_of(m, v)] = {v, to_vec3(point(m, v))};
  for (const poly_t<M> p : polys(m)) d.polys[index_of(m, p)] = {p, described_shape(m, p)};
  for (const edge_t<M> e : edges(m))
    if (adj_e2p(m, e).begin() != adj_e2p(m, e).end()) describe_lower(m, e, adj_e2v(m, e), d.edges);
  if constexpr (VolumeMesh<M>)  // surfaces have no faces
    for (const face_t<M> f : faces(m))
      if (adj_f2p(m, f).begin() != adj_f2p(m, f).end()) describe_lower(m, f, adj_f2v(m, f), d.faces);
  if constexpr (HasProperties<M>) {
    if (const auto values = find_vert_property<double>(m, label_name))
      for (auto& [i, x] : d.verts) x.value = values[x.vert];
    if (const auto values = find_poly_property<double>(m, label_name))
      for (auto& [i, x] : d.polys) x.value = values[x.poly];
  }
  return d;
}

}  // namespace concino::testing::detail
