// The factorisation of the coarsest level of multigrid; see bottom_solver.hpp.
#pragma once

#include <concino/solve/detail/direct/ordered_factors.hpp>
#include <concino/solve/detail/multigrid/bottom_solver.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace concino::detail {

CONCINO_INLINE bool bottom_solver::factorize(const Eigen::SparseMatrix<double>& a, bool& has_kernel) {
  const auto n = static_cast<std::size_t>(a.cols());
  if (n == 0) return true;
  order_.find(a);
  Eigen::SparseMatrix<double> upper = order_(a);
  std::vector<double*> diagonal(n);
  for (int c = 0; c < static_cast<int>(n); ++c)
    for (int k = upper.outerIndexPtr()[c]; k < upper.outerIndexPtr()[c + 1]; ++k)
      if (upper.innerIndexPtr()[k] == c) diagonal[static_cast<std::size_t>(c)] = upper.valuePtr() + k;
  simplicial_ldlt factors;
  factors.analyzePattern(upper);
  for (std::size_t attempt = 0; attempt < 100 + 8 * n; ++attempt) {
    factors.factorize(upper);
    const Eigen::VectorXd pivots = factors.vectorD();  // up to the first 0
    std::size_t c = 0;
    const auto is_good = [&](double pivot) { return pivot > 1e-13 * *diagonal[c] && std::isfinite(pivot); };
    while (c < n && is_good(pivots[static_cast<Eigen::Index>(c)])) ++c;
    if (c == n) {
      lower_ = factors.matrixL().nestedExpression();
      pivots_.assign(pivots.data(), pivots.data() + n);
      return true;
    }
    *diagonal[c] *= attempt < n ? 2 : 64;
    has_kernel = true;
  }
  return false;
}

}  // namespace concino::detail
