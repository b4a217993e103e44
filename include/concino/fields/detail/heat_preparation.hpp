// What heat geodesics read from a mesh before they are asked anything: gradients at corners, the boundary, matrices; and how they go on where
// there is no heat to follow.
#pragma once

#include <concino/fields/detail/heat_system.hpp>
#include <concino/geometry/edge_length.hpp>
#include <concino/graph/detail/boundary_verts.hpp>
#include <concino/operators/detail/assembly.hpp>
#include <concino/operators/detail/poly_chunks.hpp>
#include <concino/operators/detail/simplex_gradients.hpp>
#include <concino/operators/mass_matrix.hpp>
#include <concino/operators/weights.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace concino::detail {

/// Errors: invalid_mesh that names a poly without area or volume or with points that are not finite.
template<AnyMesh M>
corner_fluxes fluxes_of(const M& m) {
  corner_fluxes r;
  const poly_chunks<M> chunks(m, [&](const poly_t<M>& p) {
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

/// The lower triangle of minus the Laplacian.
template<class M>
Eigen::SparseMatrix<double> lower_stiffness(const M& m, weights which) {
  return with_weights(
      m, which,
      [&](const auto& weights) {
        return assemble<lower_triangle>(
            m, weights, static_cast<std::size_t>(vert_index_bound(m)), 1.0, [&](const vert_t<M>& v) { return static_cast<int>(index_of(m, v)); },
            [](int, const vert_t<M>&, double) {});
      },
      [&](auto make_element) { return assemble_elements(m, make_element); });
}

/// Along each edge what its polys have for it: measure times dimension over number of edges, over the square of its length. Positive, and on grids
/// of boxes the usual differences, but no better than the directions of the edges are even elsewhere.
template<AnyMesh M>
struct positive_weights {
  const M& m;
  std::vector<double> weight;

  explicit positive_weights(const M& mesh) : m(mesh), weight(static_cast<std::size_t>(edge_index_bound(mesh))) {
    for (const poly_t<M> p : polys(m)) {
      double n = 0;
      for ([[maybe_unused]] const edge_t<M> e : adj_p2e(m, p)) n += 1;
      const double part = std::abs(measure(m, p)) * dimension_v<M> / n;
      for (const edge_t<M> e : adj_p2e(m, p)) {
        const double length = edge_length(m, e);
        weight[static_cast<std::size_t>(index_of(m, e))] += part / length / length;
      }
    }
  }
  template<class F>
  void for_each_neighbour(const vert_t<M>& v, F&& f) const {
    for (const edge_t<M> e : adj_v2e(m, v))
      for (const vert_t<M> w : adj_e2v(m, e))
        if (!(w == v)) f(w, weight[static_cast<std::size_t>(index_of(m, e))]);
  }
};

template<AnyMesh M>
Eigen::SparseMatrix<double> lower_positive_stiffness(const M& m) {
  const auto column = [&](const vert_t<M>& v) { return static_cast<int>(index_of(m, v)); };
  return assemble<lower_triangle>(m, positive_weights<M>(m), static_cast<std::size_t>(vert_index_bound(m)), 1.0, column,
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

/// Gives a value to every vert at which log_u is -inf and that can be reached along edges from others: that of a shortest way along edges, as
/// heat would have it that decays by the length over `decay`.
template<AnyMesh M>
void fill_along_edges(const M& m, double decay, std::vector<double>& log_u) {
  using entry = std::pair<double, vert_t<M>>;
  const auto at = [&](const vert_t<M>& v) -> double& { return log_u[static_cast<std::size_t>(index_of(m, v))]; };
  constexpr double none = -std::numeric_limits<double>::infinity();
  const auto less = [](const entry& a, const entry& b) { return a.first < b.first; };
  std::priority_queue<entry, std::vector<entry>, decltype(less)> queue(less);
  std::vector<unsigned char> open(log_u.size());
  for (const vert_t<M> v : verts(m)) open[static_cast<std::size_t>(index_of(m, v))] = at(v) == none;
  const auto spread = [&](const vert_t<M>& v) {
    const vec3 x = to_vec3(point(m, v));
    for (const vert_t<M> w : adj_v2v(m, v)) {
      if (!open[static_cast<std::size_t>(index_of(m, w))]) continue;
      const double known = at(v) - distance(x, to_vec3(point(m, w))) / decay;
      if (!(known > at(w))) continue;
      at(w) = known;
      queue.push({known, w});
    }
  };
  for (const vert_t<M> v : verts(m))
    if (!open[static_cast<std::size_t>(index_of(m, v))]) spread(v);
  while (!queue.empty()) {
    const auto [known, v] = queue.top();
    queue.pop();
    if (known == at(v)) spread(v);
  }
}

}  // namespace concino::detail
