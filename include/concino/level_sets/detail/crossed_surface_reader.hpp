// Reads the polys of any surface that a level set crosses.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/oriented_edges.hpp>
#include <concino/core/local_numbers.hpp>
#include <concino/level_sets/detail/level_place.hpp>
#include <concino/level_sets/detail/level_states.hpp>
#include <concino/level_sets/detail/poly_cuts.hpp>
#include <concino/mesh/element_origins.hpp>
#include <concino/mesh/mesh_point.hpp>

#include <cstdint>
#include <utility>
#include <vector>

namespace concino::detail {

/// The polys of a surface that a level set crosses: in flat arrays, and as descriptors by number.
template<class M>
class crossed_surface_reader {
  core::local_numbers vert_numbers_, edge_numbers_;

 public:
  crossed_surface arrays;
  std::vector<poly_t<M>> polys;
  std::vector<vert_t<M>> verts;
  std::vector<edge_t<M>> edges;

  template<class U>
  crossed_surface_reader(const M& m, const U& u, double level, std::vector<poly_t<M>> crossed) : polys(std::move(crossed)) {
    for (const poly_t<M>& p : polys) {
      for (const auto& [e, from, to] : oriented_edges(m, p)) {
        add_vert(m, u, level, from);
        add_edge(m, e);
      }
      arrays.first_corner.push_back(static_cast<std::uint32_t>(arrays.verts.size()));
    }
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
  template<class U>
  void add_vert(const M& m, const U& u, double level, const vert_t<M>& v) {
    const std::size_t index = index_of(m, v);
    const unsigned number = vert_numbers_.add(index);
    arrays.verts.push_back(number);
    if (number < verts.size()) return;
    verts.push_back(v);
    arrays.vert_indices.push_back(static_cast<std::uint32_t>(index));
    arrays.points.push_back(to_vec3(point(m, v)));
    arrays.values.push_back(static_cast<double>(u[v]));
    arrays.states.push_back(level_state(arrays.values.back(), level));
  }
  void add_edge(const M& m, const edge_t<M>& e) {
    const unsigned number = edge_numbers_.add(index_of(m, e));
    arrays.edges.push_back(number);
    if (number < edges.size()) return;
    edges.push_back(e);
    unsigned char n = 0;
    for ([[maybe_unused]] const poly_t<M> p : adj_e2p(m, e)) n = n < 3 ? static_cast<unsigned char>(n + 1) : n;
    arrays.num_polys.push_back(n);
  }
};

}  // namespace concino::detail
