// The Galerkin product of multigrid, by Eigen; see coarse_matrix.hpp.
#pragma once

#include <concino/solve/detail/multigrid/coarse_matrix.hpp>

#include <cstddef>
#include <vector>

namespace concino::detail {

// Matrices are assigned, not constructed, from expressions: Eigen's constructors leak if memory runs out.
CONCINO_INLINE Eigen::SparseMatrix<double> coarse_matrix(const Eigen::SparseMatrix<double>& lower,
                                                         const prolongation& p, bool& has_kernel) {
  const Eigen::Map<const Eigen::SparseMatrix<float, Eigen::RowMajor>> weights(
      lower.cols(), p.columns, static_cast<Eigen::Index>(p.column.size()), p.begin.data(), p.column.data(),
      p.weight.data());
  Eigen::SparseMatrix<double> q, half, product;
  q = weights.cast<double>();
  half = lower;  // with half of the diagonal: A is the sum of it and its transpose
  for (int c = 0; c < half.cols(); ++c) half.valuePtr()[half.outerIndexPtr()[c]] /= 2;
  product = half * q;
  Eigen::SparseMatrix<double>().swap(half);
  product = q.transpose() * product;
  half = product.transpose();
  product += half;
  half = product.triangularView<Eigen::Lower>();
  for (int c = 0; c < half.cols(); ++c) {
    double bound = 0;  // a sum of non-negative terms of the diagonal entry, which it may not cancel
    for (Eigen::SparseMatrix<double>::InnerIterator i(q, c); i; ++i)
      bound += i.value() * i.value() * lower.valuePtr()[lower.outerIndexPtr()[i.row()]];
    double& diagonal = half.valuePtr()[half.outerIndexPtr()[c]];
    if (diagonal > 1e-13 * bound) continue;
    diagonal = bound;
    has_kernel = true;
  }
  return half;
}

}  // namespace concino::detail
