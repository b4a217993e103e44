// Products of sparse matrices; see product.hpp.
#pragma once

#include <concino/core/product.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#ifdef CONCINO_COMPILED
template void Eigen::internal::assign_sparse_to_sparse<Eigen::SparseMatrix<double>, Eigen::SparseMatrix<double>>(
    Eigen::SparseMatrix<double>&, const Eigen::SparseMatrix<double>&);
#endif

namespace concino {

namespace detail {

inline void expect_compressed(const char* caller, const Eigen::SparseMatrix<double>& a) {
  if (!a.isCompressed())
    core::throw_joined<invalid_argument>({caller, ": a matrix is not compressed; call makeCompressed()"});
}

}  // namespace detail

CONCINO_INLINE Eigen::SparseMatrix<double> with_both_triangles(const Eigen::SparseMatrix<double>& lower) {
  if (lower.rows() != lower.cols()) throw invalid_argument("with_both_triangles: the matrix is not square");
  detail::expect_compressed("with_both_triangles", lower);
  const int n = static_cast<int>(lower.cols());
  const int* const from = lower.outerIndexPtr();
  const int* const row = lower.innerIndexPtr();
  Eigen::SparseMatrix<double> r(n, n);
  int* const begin = r.outerIndexPtr();
  for (int c = 0; c < n; ++c)
    for (int k = from[c]; k < from[c + 1]; ++k) {
      ++begin[c + 1];
      if (row[k] != c) ++begin[row[k] + 1];
    }
  std::int64_t sum = 0;
  for (int c = 0; c < n; ++c) {
    sum += begin[c + 1];
    if (sum > std::numeric_limits<int>::max())
      throw unsupported("symmetric sparse matrix: more entries than 32-bit indices can count");
    begin[c + 1] = static_cast<int>(sum);
  }
  r.resizeNonZeros(begin[n]);
  std::vector<int> end(begin, begin + n);
  int* const at = end.data();
  const auto put = [&](int i, int c, double x) {
    r.innerIndexPtr()[at[c]] = i;
    r.valuePtr()[at[c]++] = x;
  };
  for (int c = 0; c < n; ++c)
    for (int k = from[c]; k < from[c + 1]; ++k) {
      put(row[k], c, lower.valuePtr()[k]);
      if (row[k] != c) put(c, row[k], lower.valuePtr()[k]);
    }
  return r;
}

CONCINO_INLINE Eigen::SparseMatrix<double> scaled_product(const Eigen::SparseMatrix<double>& a,
                                                          const std::vector<double>& d,
                                                          const Eigen::SparseMatrix<double>& b) {
  if (static_cast<std::size_t>(a.cols()) != d.size() || static_cast<std::size_t>(b.rows()) != d.size())
    core::throw_joined<invalid_argument>({"scaled_product: there are ", static_cast<std::size_t>(a.cols()),
                                          " columns of a, ", d.size(), " factors and ",
                                          static_cast<std::size_t>(b.rows()), " rows of b; the numbers must be equal"});
  detail::expect_compressed("scaled_product", a);
  detail::expect_compressed("scaled_product", b);
  const auto n = static_cast<std::size_t>(b.cols()), height = static_cast<std::size_t>(a.rows());
  std::vector<int> first{0}, rows;
  std::vector<double> values, sum(height);
  std::vector<std::size_t> seen_in(height, n);  // the last column in which a row occurred
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
      throw unsupported(
          "product of sparse matrices: more entries than 32-bit indices can count; use a smaller exponent");
    std::sort(rows.data() + begin, rows.data() + rows.size());
    for (std::size_t k = begin; k < rows.size(); ++k) values.push_back(sum[static_cast<std::size_t>(rows[k])]);
    first.push_back(static_cast<int>(rows.size()));
  }
  Eigen::SparseMatrix<double> r(a.rows(), b.cols());
  r.resizeNonZeros(static_cast<Eigen::Index>(rows.size()));
  std::copy_n(first.data(), first.size(), r.outerIndexPtr());
  std::copy_n(rows.data(), rows.size(), r.innerIndexPtr());
  std::copy_n(values.data(), values.size(), r.valuePtr());
  return r;
}

}  // namespace concino
