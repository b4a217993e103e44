// The matrices of heat geodesics: masses plus a time times the stiffness, with or without Dirichlet conditions.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/fields/detail/problems/laplace_system.hpp>
#include <concino/fields/detail/problems/scaled_mesh.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

namespace concino::detail {

/// The lower triangle of the stiffness matrix of the mesh at the size of `scaled`.
template<class M, class D>
Eigen::SparseMatrix<double> lower_stiffness_at(const views::scaled<M>& scaled, const M& m, const D& discretisation) {
  if constexpr (scales_with<D, M>) {
    return lower_stiffness(scaled, discretisation);
  } else {
    Eigen::SparseMatrix<double> a = lower_stiffness(m, discretisation);
    for (Eigen::Index k = 0; k < a.nonZeros(); ++k)
      a.valuePtr()[k] = std::ldexp(a.valuePtr()[k], (2 - dimension_v<M>)*scaled.exponent());
    return a;
  }
}

/// A lower triangle in which each column without entries, as those of deleted verts are, gets a diagonal entry of 0.
/// Entries that are inserted later would leave a matrix that is not compressed, whose columns do not end where the next
/// one begins.
inline Eigen::SparseMatrix<double> with_diagonal(Eigen::SparseMatrix<double> lower) {
  const int* const begin = lower.outerIndexPtr();
  if (std::adjacent_find(begin, begin + lower.cols() + 1) == begin + lower.cols() + 1) return lower;
  Eigen::SparseMatrix<double> zero(lower.rows(), lower.cols());
  zero.setIdentity();
  zero *= 0;
  return lower + zero;
}

/// The lower triangle of the masses plus `flow` times the stiffness a; mass(c) is the mass of column c.
template<class Mass>
Eigen::SparseMatrix<double> lower_heat_matrix(Eigen::SparseMatrix<double> a, double flow, const Mass& mass) {
  for (int c = 0; c < a.cols(); ++c)
    for (int k = a.outerIndexPtr()[c]; k < a.outerIndexPtr()[c + 1]; ++k) {
      a.valuePtr()[k] *= flow;
      if (a.innerIndexPtr()[k] == c) a.valuePtr()[k] += mass(c);
    }
  return a;
}

/// The heat matrix a with Dirichlet conditions at these verts. Heat there is not quite 0, so that it has a logarithm
/// and sources there heat the rest.
inline Eigen::SparseMatrix<double> with_dirichlet_verts(Eigen::SparseMatrix<double> a,
                                                        std::span<const unsigned char> is_dirichlet) {
  for (int c = 0; c < a.cols(); ++c)
    if (is_dirichlet[static_cast<std::size_t>(c)]) a.coeffRef(c, c) *= 1e6;
  return a;
}

}  // namespace concino::detail
