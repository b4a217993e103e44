// Which numbers stand on the edges of a Laplacian, and how they are computed.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/concepts/primal_graph.hpp>
#include <concino/detail/number_text.hpp>
#include <concino/error.hpp>
#include <concino/geometry/vec3.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace concino {

/// uniform:   1 on every edge; any graph.
/// cotangent: minus the measure of each triangle or tet times the scalar product of the gradients of the hat functions of the edge's
///            ends, summed: half the cotangents of the angles opposite the edge on surfaces, a sixth of the lengths of the opposite
///            edges times the cotangents of the dihedral angles there in volumes. Negative weights are kept: they are what makes
///            linear functions harmonic.
enum class weights { uniform, cotangent };

namespace detail {

/// A triangle (D = 2) or tet (D = 3) and the weights it adds to its edges.
///
/// In any dimension the gradient of the hat function of corner i is -s_i / (D |p|), where s_i is the facet opposite i as an outward
/// vector, so the weight of edge ij is -|p| grad_i . grad_j = -s_i . s_j / (D^2 |p|).
template<int D>
struct simplex_weights {
  std::array<vec3, D + 1> facet;
  double factor = 0;  // not finite for a degenerate simplex

  explicit simplex_weights(const std::array<vec3, D + 1>& x) {
    if constexpr (D == 2) {
      facet = {x[2] - x[1], x[0] - x[2], x[1] - x[0]};  // edges stand for their normals in the plane: the same lengths and angles
      factor = -0.5 / norm(cross(facet[1], facet[2]));
    } else {
      const vec3 a = x[1] - x[0], b = x[2] - x[0], c = x[3] - x[0];
      facet = {vec3{}, cross(b, c), cross(c, a), cross(a, b)};
      facet[0] = -(facet[1] + facet[2] + facet[3]);
      factor = -1 / (6 * std::abs(dot(a, facet[1])));
    }
  }

  double operator()(std::size_t i, std::size_t j) const { return factor * dot(facet[i], facet[j]); }
};

/// 1 on every edge.
template<PrimalGraph M>
struct uniform_weights {
  const M& m;

  template<class F>
  void for_each_neighbour(const vert_t<M>& v, F&& f) const {
    for (const vert_t<M> w : adj_v2v(m, v)) f(w, 1.0);
  }
};

/// One number per edge, summed over the polys at it.
template<AnyMesh M>
  requires Embedded<M>
class cotangent_weights {
  const M& m_;
  std::vector<double> weight_;

  static constexpr int dimension = dimension_v<M>;
  static constexpr std::size_t corners = static_cast<std::size_t>(dimension) + 1;

  void add(const poly_t<M>& p) {
    std::array<vert_t<M>, corners> corner;
    std::array<vec3, corners> x;
    std::size_t n = 0;
    for (const vert_t<M> v : adj_p2v(m_, p)) {
      if (n < corners) {
        corner[n] = v;
        x[n] = to_vec3(point(m_, v));
      }
      ++n;
    }
    if (n != corners)
      throw unsupported("cotangent weights: poly " + number_text(index_of(m_, p)) + " has " + number_text(n) + " verts and is no " +
                        (dimension == 2 ? "triangle" : "tet") + "; use uniform weights, or split the polys");
    const simplex_weights<dimension> weight(x);
    double sum = 0;
    for (const edge_t<M> e : adj_p2e(m_, p)) {
      std::size_t ends[2] = {0, 0}, k = 0;
      for (const vert_t<M> v : adj_e2v(m_, e)) {
        std::size_t i = 0;
        while (i + 1 < corners && !(corner[i] == v)) ++i;
        if (k < 2) ends[k++] = i;
      }
      const double w = weight(ends[0], ends[1]);
      sum += w;
      weight_[index_of(m_, e)] += w;
    }
    if (!std::isfinite(sum))
      throw invalid_mesh("cotangent weights: poly " + number_text(index_of(m_, p)) +
                         " is degenerate: it has no area or volume, so its angles have no cotangents; remove it or move its verts");
  }

 public:
  explicit cotangent_weights(const M& m) : m_(m), weight_(static_cast<std::size_t>(edge_index_bound(m))) {
    for (const poly_t<M> p : polys(m)) add(p);
  }

  template<class F>
  void for_each_neighbour(const vert_t<M>& v, F&& f) const {
    for (const edge_t<M> e : adj_v2e(m_, v)) {
      const double w = weight_[index_of(m_, e)];
      for (const vert_t<M> end : adj_e2v(m_, e))
        if (!(end == v)) f(end, w);
    }
  }
};

/// Calls f with the weights that were asked for.
template<PrimalGraph M, class F>
decltype(auto) with_weights(const M& m, weights which, F&& f) {
  if (which == weights::cotangent) {
    if constexpr (AnyMesh<M> && Embedded<M>) return f(cotangent_weights<M>(m));
    else throw unsupported("cotangent weights: the mesh type is a graph without polys or points; use uniform weights");
  }
  return f(uniform_weights<M>{m});
}

}  // namespace detail

}  // namespace concino
