// Eigenvalues of the matrices of polys; see stability.hpp.
#pragma once

#include <concino/operators/stability.hpp>

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace concino::detail {

CONCINO_INLINE double eigenvalue_ratio(const std::vector<double>& lower_triangle, std::size_t n) {
  const auto size = static_cast<Eigen::Index>(n);
  Eigen::MatrixXd full(size, size);
  for (Eigen::Index i = 0, k = 0; i < size; ++i)
    for (Eigen::Index j = 0; j <= i; ++j, ++k)
      full(i, j) = full(j, i) = lower_triangle[static_cast<std::size_t>(k)];
  if (n < 2 || !full.allFinite()) return 0;
  const double largest = full.cwiseAbs().maxCoeff();
  if (!(largest > 0)) return 0;
  const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(full / largest, Eigen::EigenvaluesOnly).eigenvalues();
  return std::max(0.0, values[1]) / values[size - 1];  // the first one is that of the constants
}

}  // namespace concino::detail
