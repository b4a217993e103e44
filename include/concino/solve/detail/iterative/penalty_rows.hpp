// The energy of a vector without that of penalties, for the stopping rule of iterations.
#pragma once

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace concino::detail {

/// The rows of a symmetric matrix whose diagonal entry is far larger than the sum of the others, as large penalties
/// make them. They have nearly all of the energy of a solution, however small the rest of it is. The matrix is passed
/// as its lower triangle; each column begins with its diagonal entry.
class penalty_rows {
  std::vector<double> diagonal_;  // without penalties: of such a row, the sum of its other entries; empty if there are
                                  // none
  const Eigen::SparseMatrix<double>& a_;

 public:
  explicit penalty_rows(const Eigen::SparseMatrix<double>& a) : a_(a) {
    constexpr double large = 10;
    const auto n = static_cast<int>(a.cols());
    const int *const starts = a.outerIndexPtr(), *const rows = a.innerIndexPtr();
    diagonal_.resize(static_cast<std::size_t>(n));
    for (int c = 0; c < n; ++c)
      for (int k = starts[c] + 1; k < starts[c + 1]; ++k) {
        const double x = std::abs(a.valuePtr()[k]);
        diagonal_[static_cast<std::size_t>(c)] += x;
        diagonal_[static_cast<std::size_t>(rows[k])] += x;
      }
    std::size_t num_penalties = 0;
    for (int c = 0; c < n; ++c) {
      const double d = a.valuePtr()[starts[c]];
      double& others = diagonal_[static_cast<std::size_t>(c)];
      if (d > large * others) ++num_penalties;
      else others = d;
    }
    if (num_penalties == 0 || num_penalties == diagonal_.size()) diagonal_.clear();
  }

  /// Whether some rows are penalties. If all are, none is called so.
  bool any() const { return !diagonal_.empty(); }

  /// x.Ax without penalties; at least what can be told from rounding errors. `any` must be true.
  double energy_of_rest(const Eigen::VectorXd& x) const {
    constexpr double accuracy = 1e-12;
    const int *const starts = a_.outerIndexPtr(), *const rows = a_.innerIndexPtr();
    double energy = 0, of_diagonal = 0;
    for (int c = 0; c < a_.cols(); ++c) {
      double sum = 0;
      for (int k = starts[c] + 1; k < starts[c + 1]; ++k) sum += a_.valuePtr()[k] * x[rows[k]];
      of_diagonal += diagonal_[static_cast<std::size_t>(c)] * x[c] * x[c];
      energy += 2 * sum * x[c];
    }
    return std::max(of_diagonal + energy, accuracy * of_diagonal);
  }

  /// x.y without the rows of penalties. `any` must be true.
  double product_of_rest(const Eigen::VectorXd& x, const Eigen::VectorXd& y) const {
    double sum = 0;
    for (int c = 0; c < a_.cols(); ++c)
      if (diagonal_[static_cast<std::size_t>(c)] == a_.valuePtr()[a_.outerIndexPtr()[c]]) sum += x[c] * y[c];
    return sum;
  }
};

}  // namespace concino::detail
