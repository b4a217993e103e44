// Reads the polys of any surface that a level set crosses.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/oriented_edges.hpp>
#include <concino/core/local_numbers.hpp>
#include <concino/level_sets/detail/cut/level_place.hpp>
#include <concino/level_sets/detail/cut/level_states.hpp>
#include <concino/level_sets/detail/cut/poly_cuts.hpp>
#include <concino/mesh/element_origins.hpp>
#include <concino/mesh/mesh_point.hpp>

#include <cstdint>
#include <utility>
#include <vector>

namespace concino::detail {

/// The polys of a surface that a level set crosses: in flat arrays, and as descriptors by number.
template<class M>
class crossed_surface_reader {
  struct corner {
    vert_t<M> vert;
    edge_t<M> edge;  // to the next corner
  };

 public:
  crossed_surface arrays;
  std::vector<poly_t<M>> polys;
  std::vector<vert_t<M>> verts;
  std::vector<edge_t<M>> edges;

  template<class U>
  crossed_surface_reader(const M& m, const U& u, double level, std::vector<poly_t<M>> crossed)
      : polys(std::move(crossed)) {
    const std::vector<corner> corners = read_corners(m);
    number(m, corners);
    read_verts(m, u, level);
    read_edges(m);
  }

  mesh_point<M> mesh_point_of(const M& m, const level_place& x, double level) const {
    if (x.kind == level_place::vert) return {verts[x.above], arrays.points[x.above]};
    const double t = crossing_parameter(arrays.values[x.below], arrays.values[x.above], level);
    const vec3 position = crossing_point(arrays.points[x.below], arrays.points[x.above], t);
    if (x.kind == level_place::inside) return {polys[x.element], position};
    const edge_t<M>& e = edges[x.element];
    return {edge_point<M>{e, end_verts(m, e).first == verts[x.below] ? t : 1 - t}, position};
  }

  /// The verts of the mesh of which a place was made.
  std::vector<origin> origins_of(const level_place& x, double level) const {
    if (x.kind == level_place::vert) return {{arrays.vert_indices[x.above]}};
    const double t = crossing_parameter(arrays.values[x.below], arrays.values[x.above], level);
    return {{arrays.vert_indices[x.below], 1 - t}, {arrays.vert_indices[x.above], t}};
  }

 private:
  std::vector<corner> read_corners(const M& m) {
    std::vector<corner> corners;
    arrays.first_corner.reserve(polys.size() + 1);
    corners.reserve(polys.size() * (arity_v<M> > 0 ? arity_v<M> : 6));
    for (const poly_t<M>& p : polys) {
      for (const auto& [e, from, to] : oriented_edges(m, p)) corners.push_back({from, e});
      arrays.first_corner.push_back(static_cast<std::uint32_t>(corners.size()));
    }
    return corners;
  }
  /// A line across triangles passes about as many verts as triangles, and twice as many edges.
  void number(const M& m, const std::vector<corner>& corners) {
    core::local_numbers vert_numbers, edge_numbers;
    arrays.verts.reserve(corners.size()), arrays.edges.reserve(corners.size());
    for (const corner& c : corners) {
      arrays.verts.push_back(vert_numbers.add(index_of(m, c.vert)));
      if (arrays.verts.back() == verts.size()) verts.push_back(c.vert);
    }
    for (const corner& c : corners) {
      arrays.edges.push_back(edge_numbers.add(index_of(m, c.edge)));
      if (arrays.edges.back() == edges.size()) edges.push_back(c.edge);
    }
  }
  template<class U>
  void read_verts(const M& m, const U& u, double level) {
    const std::size_t n = verts.size();
    arrays.vert_indices.reserve(n), arrays.points.reserve(n), arrays.values.reserve(n), arrays.states.reserve(n);
    for (const vert_t<M>& v : verts) arrays.vert_indices.push_back(static_cast<std::uint32_t>(index_of(m, v)));
    for (const vert_t<M>& v : verts) arrays.points.push_back(to_vec3(point(m, v)));
    for (const vert_t<M>& v : verts) arrays.values.push_back(static_cast<double>(u[v]));
    for (const double x : arrays.values) arrays.states.push_back(level_state(x, level));
  }
  void read_edges(const M& m) {
    arrays.num_polys.reserve(edges.size());
    for (const edge_t<M>& e : edges) {
      unsigned char n = 0;
      for ([[maybe_unused]] const poly_t<M> p : adj_e2p(m, e)) n = n < 3 ? static_cast<unsigned char>(n + 1) : n;
      arrays.num_polys.push_back(n);
    }
  }
};

}  // namespace concino::detail
