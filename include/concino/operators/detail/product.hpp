// The product of sparse matrices that powers of an operator need. Eigen's own adds a second to the compile time of every program that
// includes it.
#pragma once

#include <concino/error.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace concino::detail {

/// a diag(d) b for square matrices of one size, rows sorted within columns.
/// Source: Gustavson 1978, "Two fast algorithms for sparse matrices".
inline Eigen::SparseMatrix<double> scaled_product(const Eigen::SparseMatrix<double>& a, const std::vector<double>& d, const Eigen::SparseMatrix<double>& b) {
  const auto n = static_cast<std::size_t>(a.cols());
  std::vector<int> first{0}, rows;
  std::vector<double> values, sum(n);
  std::vector<std::size_t> seen_in(n, n);  // the column for which a row was last met
  first.reserve(n + 1);
  for (std::size_t c = 0; c < n; ++c) {
    const std::size_t begin = rows.size();
    for (int k = b.outerIndexPtr()[c]; k < b.outerIndexPtr()[c + 1]; ++k) {
      const auto j = static_cast<std::size_t>(b.innerIndexPtr()[k]);
      const double factor = d[j] * b.valuePtr()[k];
      for (int l = a.outerIndexPtr()[j]; l < a.outerIndexPtr()[j + 1]; ++l) {
        const int row = a.innerIndexPtr()[l];
        const auto i = static_cast<std::size_t>(row);
        if (seen_in[i] != c) {
          seen_in[i] = c;
          sum[i] = 0;
          rows.push_back(row);
        }
        sum[i] += a.valuePtr()[l] * factor;
      }
    }
    if (rows.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
      throw unsupported("product of sparse matrices: more entries than 32-bit indices can count; use a smaller exponent");
    std::sort(rows.begin() + static_cast<std::ptrdiff_t>(begin), rows.end());
    for (std::size_t k = begin; k < rows.size(); ++k) values.push_back(sum[static_cast<std::size_t>(rows[k])]);
    first.push_back(static_cast<int>(rows.size()));
  }
  Eigen::SparseMatrix<double> r(a.rows(), a.cols());
  r.resizeNonZeros(static_cast<Eigen::Index>(rows.size()));
  std::copy(first.begin(), first.end(), r.outerIndexPtr());
  std::copy(rows.begin(), rows.end(), r.innerIndexPtr());
  std::copy(values.begin(), values.end(), r.valuePtr());
  return r;
}

}  // namespace concino::detail
