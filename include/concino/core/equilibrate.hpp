// Equilibration: scales rows and columns by powers of two, so that small entries are not hidden by large ones, whatever
// the units of rows and columns.
#pragma once

#include <concino/core/system_checks.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace concino::core {

/// Divides each column of a compressed matrix by the power of two below its largest entry. Result: the factors, one per
/// column.
inline std::vector<double> scale_columns(Eigen::SparseMatrix<double>& a) {
  std::vector<double> scale(static_cast<std::size_t>(a.cols()));
  for (int c = 0; c < a.cols(); ++c) {
    double* const first = a.valuePtr() + a.outerIndexPtr()[c];
    double* const last = a.valuePtr() + a.outerIndexPtr()[c + 1];
    double largest = 0;
    for (const double* x = first; x != last; ++x) largest = std::max(largest, std::abs(*x));
    const double factor = scale[static_cast<std::size_t>(c)] = core::power_of_two_to_scale(largest);
    for (double* x = first; x != last; ++x) *x *= factor;
  }
  return scale;
}

struct equilibration {
  std::vector<double> rows, columns;
};

/// Scales rows and columns of a compressed matrix until the largest entry of each is near 1: within a factor of 4,
/// unless the iteration alternates. Symmetric matrices stay symmetric, and d_i m_ij d_j has the same result as m_ij.
/// Result: the factors.
/// Source: Ruiz 2001.
inline equilibration equilibrate(Eigen::SparseMatrix<double>& a) {
  const auto rows = static_cast<std::size_t>(a.rows()), columns = static_cast<std::size_t>(a.cols());
  double all = 0;
  for (Eigen::Index k = 0; k < a.nonZeros(); ++k) all = std::max(all, std::abs(a.valuePtr()[k]));
  all = core::power_of_two_to_scale(all);  // first, so that multiples of a have the same result
  for (Eigen::Index k = 0; k < a.nonZeros(); ++k) a.valuePtr()[k] *= all;
  equilibration scale{std::vector<double>(rows, all), std::vector<double>(columns, 1.0)};
  std::vector<double> row(rows), column(columns);
  for (int round = 0; round < 12; ++round) {
    std::fill(row.begin(), row.end(), 0.0);
    std::fill(column.begin(), column.end(), 0.0);
    for (std::size_t c = 0; c < columns; ++c)
      for (int k = a.outerIndexPtr()[c]; k < a.outerIndexPtr()[c + 1]; ++k) {
        double& r = row[static_cast<std::size_t>(a.innerIndexPtr()[k])];
        const double x = std::abs(a.valuePtr()[k]);
        if (x > r) r = x;
        if (x > column[c]) column[c] = x;
      }
    bool done = true;
    const auto update = [&](std::vector<double>& largest, std::vector<double>& total) {
      for (std::size_t i = 0; i < largest.size(); ++i) {
        const int half = largest[i] > 0 ? std::ilogb(largest[i]) / 2 : 0;
        done &= half == 0;
        largest[i] = std::ldexp(1.0, -half);
        total[i] *= largest[i];
      }
    };
    update(row, scale.rows);
    update(column, scale.columns);
    if (done) break;
    for (std::size_t c = 0; c < columns; ++c)
      for (int k = a.outerIndexPtr()[c]; k < a.outerIndexPtr()[c + 1]; ++k) {
        // one after the other: their product may be too large
        a.valuePtr()[k] *= row[static_cast<std::size_t>(a.innerIndexPtr()[k])];
        a.valuePtr()[k] *= column[c];
      }
  }
  return scale;
}

inline Eigen::VectorXd scaled(Eigen::VectorXd x, const std::vector<double>& scale) {
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] *= scale[static_cast<std::size_t>(i)];
  return x;
}

}  // namespace concino::core
