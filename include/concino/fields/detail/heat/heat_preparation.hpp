// What heat geodesics compute from a mesh in advance: gradients at corners, the boundary and matrices. Also shortest
// paths along edges, which replace heat where it vanishes.
#pragma once

#include <concino/core/assembly.hpp>
#include <concino/core/poly_chunks.hpp>
#include <concino/fields/detail/heat/build_distance_graph.hpp>
#include <concino/fields/detail/heat/distance_bounds.hpp>
#include <concino/fields/detail/heat/heat_system.hpp>
#include <concino/geometry/edge_length.hpp>
#include <concino/graph/boundary_verts.hpp>
#include <concino/graph/dijkstra.hpp>
#include <concino/operators/mass_matrix.hpp>
#include <concino/operators/simplex_gradients.hpp>
#include <concino/operators/stiffness.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace concino::detail {

/// Errors: invalid_mesh, naming a poly without area or volume or with points that are not finite.
template<AnyMesh M>
corner_fluxes fluxes_of(const M& m) {
  corner_fluxes r;
  const core::poly_chunks<M> chunks(m, [&](const poly_t<M>& p) {
    std::size_t n = 0;
    for ([[maybe_unused]] const vert_t<M> v : adj_p2v(m, p)) ++n;
    r.begin.push_back(r.begin.back() + n);
    return n;
  });
  r.vert.resize(chunks.num_corners());
  r.flux.resize(chunks.num_corners());
  chunks.template for_each<poly_gradients<M>>([&](auto& local, const poly_t<M>& p, std::size_t corner) {
    local.visit(m, p);
    if (!local.has_gradients()) throw_no_measure("heat_geodesics", m, p);
    const double size = std::abs(local.measure);
    for (std::size_t k = 0; k < local.verts.size(); ++k) {
      r.vert[corner + k] = static_cast<int>(index_of(m, local.verts[k]));
      r.flux[corner + k] = size * local.gradient[k];
    }
    return local.verts.size();
  });
  return r;
}

/// Weights of edges: the sum over the polys of an edge of measure times dimension over the number of edges, divided by
/// its squared length. They are positive. On grids of boxes they are the usual finite differences; elsewhere they are
/// only as good as the directions of the edges are even.
template<AnyMesh M>
struct positive_weights {
  const M& m;
  std::vector<double> weight;

  explicit positive_weights(const M& mesh) : m(mesh), weight(edge_index_bound(mesh)) {
    for (const poly_t<M> p : polys(m)) {
      double n = 0;
      for ([[maybe_unused]] const edge_t<M> e : adj_p2e(m, p)) n += 1;
      const double part = std::abs(measure(m, p)) * dimension_v<M> / n;
      for (const edge_t<M> e : adj_p2e(m, p)) {
        const double length = edge_length(m, e);
        weight[index_of(m, e)] += part / length / length;
      }
    }
  }
  template<class F>
  void for_each_neighbour(const vert_t<M>& v, F&& f) const {
    for (const edge_t<M> e : adj_v2e(m, v))
      for (const vert_t<M> w : adj_e2v(m, e))
        if (!(w == v)) f(w, weight[index_of(m, e)]);
  }
};

template<AnyMesh M>
Eigen::SparseMatrix<double> lower_positive_stiffness(const M& m) {
  const auto column = [&](const vert_t<M>& v) { return static_cast<int>(index_of(m, v)); };
  return core::assemble<core::lower_triangle>(m, positive_weights<M>(m), vert_index_bound(m), 1.0, column,
                                  [](int, const vert_t<M>&, double) {});
}

/// 0 where there are no edges.
template<AnyMesh M>
double mean_edge_length(const M& m) {
  double sum = 0, n = 0;
  for (const edge_t<M> e : edges(m)) {
    sum += edge_length(m, e);
    n += 1;
  }
  return n > 0 ? sum / n : 0;
}

/// The approximate diameter of a poly: twice the distance from the mean of its verts to the farthest one. 0 for a poly
/// without verts.
template<AnyMesh M>
double poly_width(const M& m, const poly_t<M>& p) {
  vec3 mean;
  double n = 0, farthest = 0;
  for (const vert_t<M> v : adj_p2v(m, p)) {
    mean += to_vec3(point(m, v));
    n += 1;
  }
  if (n > 0) mean = mean / n;
  for (const vert_t<M> v : adj_p2v(m, p)) farthest = std::max(farthest, distance(mean, to_vec3(point(m, v))));
  return 2 * farthest;
}

/// The sum of the squared widths of polys times their measures, and the sum of the measures.
struct square_width_sums {
  double sum = 0, measure = 0;

  /// The squared width of polys, averaged by measure. Its root is the length that the mesh can resolve. Many small
  /// polys in a corner, or many short edges around a poly, do not change heat flow between distant places. A long thin
  /// poly resolves nothing finer than its length.
  double mean() const { return measure > 0 ? sum / measure : 0; }
};

template<AnyMesh M>
square_width_sums square_widths(const M& m) {
  square_width_sums r;
  for (const poly_t<M> p : polys(m)) {
    const double size = std::abs(measure(m, p)), width = poly_width(m, p);
    r.sum += size * width * width;
    r.measure += size;
  }
  return r;
}

/// How long heat flows if no time is chosen.
template<AnyMesh M>
double default_heat_time(const square_width_sums& widths) { return 2 * widths.mean() / dimension_v<M>; }

/// Raises log_u at the open verts that can be reached along edges from verts with a value: to the value at the end of a
/// shortest path minus its length over `decay`. Heat decays in the same way. Paths pass through open verts only.
template<AnyMesh M>
void fill_along_edges(const M& m, double decay, const std::vector<unsigned char>& is_open, std::vector<double>& log_u) {
  constexpr double none = -std::numeric_limits<double>::infinity();
  const auto at = [&](const vert_t<M>& v) -> double& { return log_u[static_cast<std::size_t>(index_of(m, v))]; };
  std::vector<vert_t<M>> beside;  // verts with a value and an open neighbour
  for (const vert_t<M> v : verts(m)) {
    if (at(v) == none) continue;
    for (const vert_t<M> w : adj_v2v(m, v)) {
      if (!is_open[index_of(m, w)]) continue;
      beside.push_back(v);
      break;
    }
  }
  if (beside.empty()) return;
  const auto length = [&](const vert_t<M>& v, const vert_t<M>& w) {
    return distance(to_vec3(point(m, v)), to_vec3(point(m, w))) / decay;
  };
  const auto known = concino::dijkstra(m, beside, length,
                                       {.may_enter = [&](const vert_t<M>& v) { return is_open[index_of(m, v)] != 0; },
                                        .initial_distance = [&](const vert_t<M>& v) { return -at(v); }});
  for (const vert_t<M> v : verts(m))
    if (is_open[index_of(m, v)]) at(v) = std::max(at(v), -known[v]);
}

}  // namespace concino::detail
