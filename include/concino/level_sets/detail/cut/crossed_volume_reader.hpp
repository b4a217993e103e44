// Reads the polys of any volume that a level set crosses.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/oriented_edges.hpp>
#include <concino/level_sets/detail/cut/crossed_volume.hpp>
#include <concino/level_sets/detail/cut/level_place.hpp>
#include <concino/level_sets/detail/cut/level_states.hpp>
#include <concino/mesh/element_origins.hpp>
#include <concino/mesh/mesh_point.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// The polys of a volume that a level set crosses: in flat arrays, and as descriptors by number.
template<class M>
class crossed_volume_reader {
  core::local_numbers edge_numbers_;

 public:
  crossed_volume arrays;
  std::vector<poly_t<M>> polys;
  std::vector<std::uint32_t> poly_indices;
  std::vector<vert_t<M>> verts;  // by number; a face that was replaced by triangles has its first vert at its centre
  std::vector<edge_t<M>> edges;  // crossed ones
  std::vector<face_t<M>> faces;  // by facet

  template<class U>
  crossed_volume_reader(const M& m, const U& u, double level, std::vector<poly_t<M>> crossed)
      : arrays(level, edge_index_bound(m)), polys(std::move(crossed)) {
    count_and_reserve(m);
    for (const poly_t<M>& p : polys) {
      poly_indices.push_back(static_cast<std::uint32_t>(index_of(m, p)));
      for (const face_t<M> f : adj_p2f(m, p)) add_facet(m, u, p, f);
      arrays.end_cell();
    }
  }

  mesh_point<M> mesh_point_of(const M& m, const level_place& x) const {
    const bool is_vert = x.kind == level_place::vert;
    const double t = is_vert ? 1 : crossing_parameter(arrays.values[x.below], arrays.values[x.above], arrays.level());
    const vec3 position =
        is_vert ? arrays.points[x.above] : crossing_point(arrays.points[x.below], arrays.points[x.above], t);
    for (const std::uint32_t end : {x.below, x.above})
      if (arrays.vert_indices[end] == arrays.none) return {faces[centre_at(end).facet], position};
    if (is_vert) return {verts[x.above], position};
    if (x.kind == level_place::inside) return {face_of_index(x.element), position};
    const edge_t<M>& e = edges[edge_numbers_.find(x.element)];
    return {edge_point<M>{e, end_verts(m, e).first == verts[x.below] ? t : 1 - t}, position};
  }

  /// The verts of the mesh of which a place was made.
  std::vector<origin> origins_of(const level_place& x) const {
    std::vector<origin> list;
    const double t = x.kind == level_place::vert
                         ? 1
                         : crossing_parameter(arrays.values[x.below], arrays.values[x.above], arrays.level());
    if (x.kind != level_place::vert) add_origins(x.below, 1 - t, list);
    add_origins(x.above, t, list);
    return list;
  }

 private:
  /// Adds the verts of the mesh of which a vert was made: itself, or the corners of a face at its centre.
  void add_origins(std::uint32_t vert, double weight, std::vector<origin>& list) const {
    if (arrays.vert_indices[vert] != arrays.none) {
      list.push_back({arrays.vert_indices[vert], weight});
      return;
    }
    const crossed_volume::fan& f = arrays.fans[arrays.fan_of[centre_at(vert).facet]];
    for (std::uint32_t k = f.first_corner; k < f.last_corner; ++k)
      list.push_back(
          {arrays.vert_indices[arrays.whole_verts[k]], weight / static_cast<double>(f.last_corner - f.first_corner)});
  }
  void count_and_reserve(const M& m) {
    std::size_t num_facets = 0, num_corners = 0;
    for (const poly_t<M>& p : polys)
      for (const face_t<M> f : adj_p2f(m, p)) ++num_facets, num_corners += num_elements(adj_f2v(m, f));
    arrays.reserve(polys.size(), num_facets, num_corners);
    faces.reserve(num_facets), verts.reserve(3 * polys.size()), edges.reserve(3 * polys.size());
  }
  template<class U>
  std::uint32_t number_of_vert(const M& m, const U& u, const vert_t<M>& v) {
    const std::size_t index = index_of(m, v);
    const std::uint32_t number = arrays.number_of_vert(index);
    if (number == arrays.points.size()) {
      arrays.add_vert(static_cast<std::uint32_t>(index), to_vec3(point(m, v)), static_cast<double>(u[v]));
      verts.push_back(v);
    }
    return number;
  }
  /// Lists an edge once. Returns its index.
  std::uint32_t add_crossed_edge(const M& m, const edge_t<M>& e) {
    const std::size_t index = index_of(m, e);
    if (edge_numbers_.add(index) == edges.size()) edges.push_back(e);
    return static_cast<std::uint32_t>(index);
  }
  template<class U>
  void add_facet(const M& m, const U& u, const poly_t<M>& p, const face_t<M>& f) {
    for (const auto& [e, from, to] : oriented_edges(m, f)) {
      const std::uint32_t number = number_of_vert(m, u, from);
      arrays.verts.push_back(number);
      const bool is_crossed = (arrays.states[number] == below_level) != (static_cast<double>(u[to]) < arrays.level());
      arrays.edges.push_back(is_crossed ? add_crossed_edge(m, e) : static_cast<std::uint32_t>(index_of(m, e)));
    }
    unsigned char n = 0;
    for ([[maybe_unused]] const poly_t<M> q : adj_f2p(m, f)) n = n < 3 ? static_cast<unsigned char>(n + 1) : n;
    arrays.end_facet(static_cast<std::uint32_t>(index_of(m, f)), face_is_outward(m, p, f), n);
    faces.resize(arrays.num_facets(), f);
    verts.resize(arrays.points.size(), verts.front());
  }

  const crossed_volume::centre& centre_at(std::uint32_t vert) const {
    return *std::lower_bound(arrays.centres.begin(), arrays.centres.end(), vert,
                             [](const crossed_volume::centre& c, std::uint32_t v) { return c.vert < v; });
  }
  face_t<M> face_of_index(std::uint32_t index) const {
    for (std::size_t s = 0; s < faces.size(); ++s)
      if (arrays.faces[s] == index) return faces[s];
    return faces.front();
  }
};

}  // namespace concino::detail
