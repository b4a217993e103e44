// A crossed edge of any mesh and the point where the level set crosses it.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/maps.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/level_sets/detail/level_place.hpp>
#include <concino/mesh/mesh_point.hpp>

#include <cstddef>

namespace concino::detail {

/// What is known of a crossed edge. It is read in steps, so that the processor waits for the memory of several edges at once.
template<class M>
struct crossed_edge {
  edge_ends<vert_t<M>> ends;
  double a, b;  // the values and points of its ends
  vec3 x, y;

  template<class U>
  void read_values(const M& m, const U& u) {
    a = static_cast<double>(u[ends.first]), b = static_cast<double>(u[ends.second]);
    x = to_vec3(point(m, ends.first)), y = to_vec3(point(m, ends.second));
  }
  /// The crossing; e is this edge.
  mesh_point<M> crossing(const edge_t<M>& e, double level) const {
    const bool rises = a < level;
    const double t = rises ? crossing_parameter(a, b, level) : crossing_parameter(b, a, level);
    return {edge_point<M>{e, rises ? t : 1 - t}, rises ? crossing_point(x, y, t) : crossing_point(y, x, t)};
  }
};

/// Calls put(k, place) with the crossing of edge_of(k), for every k below n with is_edge(k).
template<class M, class U, class IsEdge, class EdgeOf, class Put>
void cross_edges(const M& m, const U& u, double level, std::size_t n, const IsEdge& is_edge, const EdgeOf& edge_of, const Put& put) {
  constexpr std::size_t few = 32;
  crossed_edge<M> some[few];
  for (std::size_t first = 0; first < n; first += few) {
    const std::size_t size = n - first < few ? n - first : few;
    for (std::size_t k = 0; k < size; ++k)
      if (is_edge(first + k)) some[k].ends = end_verts(m, edge_of(first + k));
    for (std::size_t k = 0; k < size; ++k)
      if (is_edge(first + k)) some[k].read_values(m, u);
    for (std::size_t k = 0; k < size; ++k)
      if (is_edge(first + k)) put(first + k, some[k].crossing(edge_of(first + k), level));
  }
}

}  // namespace concino::detail
