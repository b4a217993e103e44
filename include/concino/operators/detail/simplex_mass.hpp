// The Galerkin mass of meshes of triangles or tets by type, from edges: the same matrix as that of virtual elements,
// several times faster.
#pragma once

#include <concino/core/assembly.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/operators/corner_gradients.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace concino::detail {

/// The area of the triangle, or the unsigned volume of the tet, with these corners.
template<class M, std::size_t N>
double simplex_measure(const M& m, const std::array<vert_t<M>, N>& corner) {
  const vec3 o = to_vec3(point(m, corner[0]));
  const vec3 normal = cross(to_vec3(point(m, corner[1])) - o, to_vec3(point(m, corner[2])) - o);
  if constexpr (N == 3) return norm(normal) / 2;
  else return std::abs(dot(normal, to_vec3(point(m, corner[3])) - o)) / 6;
}

/// For each edge, the integral of the product of the hat functions of its ends.
template<AnyMesh M>
class simplex_mass_weights {
  const M& m_;
  std::vector<double> weight_;

 public:
  /// Errors: invalid_mesh if a poly has no area or volume, or points that are not finite.
  explicit simplex_mass_weights(const M& m) : m_(m), weight_(edge_index_bound(m)) {
    constexpr int d = dimension_v<M>;
    for (const poly_t<M> p : polys(m)) {
      std::array<vert_t<M>, arity_v<M>> corner;
      std::size_t n = 0;
      for (const vert_t<M> v : adj_p2v(m, p))
        if (n < corner.size()) corner[n++] = v;
      const double size = simplex_measure(m, corner);
      if (!(size > 0 && std::isfinite(size))) throw_no_measure("mass matrix", m, p);
      const double weight = size / ((d + 1) * (d + 2));
      for (const edge_t<M> e : adj_p2e(m, p)) weight_[index_of(m, e)] += weight;
    }
  }

  int num_neighbours(const vert_t<M>& v) const {
    int n = 0;
    for ([[maybe_unused]] const edge_t<M> e : adj_v2e(m_, v)) ++n;
    return n;
  }
  template<class F>
  void for_each_neighbour(const vert_t<M>& v, F&& f) const {
    for (const edge_t<M> e : adj_v2e(m_, v)) {
      const double weight = weight_[index_of(m_, e)];
      for (const vert_t<M> w : adj_e2v(m_, e))
        if (!(w == v)) f(w, weight);
    }
  }
};

/// The mass matrix, both triangles.
template<AnyMesh M>
Eigen::SparseMatrix<double> simplex_mass(const M& m) {
  Eigen::SparseMatrix<double> a = core::assemble<core::whole_matrix>(
      m, simplex_mass_weights<M>(m), vert_index_bound(m), -1.0,
      [&](const vert_t<M>& v) { return static_cast<int>(index_of(m, v)); }, [](int, const vert_t<M>&, double) {});
  // A simplex has `dimension` edges at a vert. The integral of the squared hat function of a vert is twice that of an
  // edge.
  constexpr double factor = -2.0 / dimension_v<M>;
  for (int c = 0; c < a.cols(); ++c)
    for (int k = a.outerIndexPtr()[c]; k < a.outerIndexPtr()[c + 1]; ++k)
      if (a.innerIndexPtr()[k] == c) a.valuePtr()[k] *= factor;
  return a;
}

}  // namespace concino::detail
