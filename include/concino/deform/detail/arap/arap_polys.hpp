// As rigid as possible with spokes and rims: the matrices of polys.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>
#include <concino/deform/detail/skin/best_rotation.hpp>
#include <concino/operators/discretisation.hpp>

#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// The energy is the sum, over the polys and their verts, of the weights of pairs of verts of the poly times the
/// squared difference between the pair and its rest, rotated by the rotation of the vert. The sum over the pairs of a
/// poly is not negative, though single weights may be. Verts are numbers.
class arap_polys {
  std::vector<std::uint32_t> first_{0}, vert_;  // the verts of each poly
  std::vector<std::size_t> first_weight_{0};
  std::vector<double> weight_;  // of each poly the pairs (1, 0), (2, 0), (2, 1), (3, 0) ...

  template<class F>
  void for_each_pair(std::size_t poly, const F& f) const {
    const double* w = weight_.data() + first_weight_[poly];
    for (std::uint32_t i = first_[poly]; i < first_[poly + 1]; ++i)
      for (std::uint32_t j = first_[poly]; j < i; ++j) f(i - first_[poly], j - first_[poly], *w++);
  }
  double energy_of(std::size_t poly, const std::vector<vec3>& rest, const std::vector<vec3>& x,
                   const std::vector<rotation_columns>& rotations, std::vector<vec3>& difference) const;

 public:
  bool is_empty() const { return vert_.empty(); }
  std::size_t num_polys() const { return first_.size() - 1; }

  /// Adds a poly with this lower triangle of its matrix, row after row.
  void add(const std::vector<std::uint32_t>& verts, const std::vector<double>& entries);

  /// Minus the matrix of the energy for given rotations, both triangles, with zeros. size: more than any vert.
  Eigen::SparseMatrix<double> laplacian(std::size_t size) const;
  void divide_weights(double unit);

  /// The moments of a vert v are the sum of out[k] * (x of to[k]) over its edges k, and the right side of its equation
  /// is the sum of the rotations of to[k] times in[k], and of its own rotation times own[v]. first, to: the edges from
  /// each vert, by the pattern of the Laplacian.
  void sum_edges(const std::vector<vec3>& rest, const std::vector<std::uint32_t>& first,
                 const std::vector<std::uint32_t>& to, std::vector<vec3>& out, std::vector<vec3>& in,
                 std::vector<vec3>& own) const;

  /// Without cancellation where the rotations of a poly are nearly equal.
  double energy(const std::vector<vec3>& rest, const std::vector<vec3>& x,
                const std::vector<rotation_columns>& rotations) const;
};

/// The matrices of the polys of m.
/// Errors: those of the discretisation.
template<class M, class D>
arap_polys arap_polys_of(const M& m, const D& discretisation) {
  arap_polys all;
  auto matrix_of = discretisation.poly_matrices(m);
  local_matrix<vert_t<M>> local;
  std::vector<std::uint32_t> index;
  for (const poly_t<M> p : polys(m)) {
    matrix_of(p, local);
    index.clear();
    for (const vert_t<M> v : local.verts) index.push_back(static_cast<std::uint32_t>(index_of(m, v)));
    all.add(index, local.entries);
  }
  return all;
}

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/deform/detail/arap/arap_polys.ipp>
#endif
