// The Galerkin product of multigrid: the matrix of a coarser level.
#pragma once

#include <concino/solve/detail/aggregates.hpp>
#include <concino/solve/detail/sorted_columns.hpp>
#include <concino/solve/detail/sparse_sums.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace concino::detail {

/// Computes P^T A P for the lower triangle of A; the result is a lower triangle too, with sorted columns. With U the upper triangle of A and half of its
/// diagonal, P^T A P = T + T^T for T = P^T U P.
class coarse_matrix {
  std::size_t n_;  // coarse unknowns
  std::vector<int> end_;  // row c of T: entries [end_[c], end_[c + 1])
  std::vector<int> column_;
  std::vector<double> value_, bound_;  // bound_: a sum of non-negative terms of the diagonal, which it may not cancel

  void multiply(const Eigen::SparseMatrix<double>& a, const prolongation& p, const restriction& by_column) {
    const int *const starts = a.outerIndexPtr(), *const rows = a.innerIndexPtr();
    const double* const x = a.valuePtr();
    sparse_sums fine(static_cast<std::size_t>(a.cols())), coarse(n_);  // row c of P^T U and of T
    for (std::size_t c = 0; c < n_; ++c) {
      for (auto m = static_cast<std::size_t>(by_column.begin[c]); m < static_cast<std::size_t>(by_column.begin[c + 1]); ++m) {
        const int i = by_column.row[m], first = starts[i], end = starts[i + 1];
        const double w = static_cast<double>(by_column.weight[m]);
        bound_[c] += w * w * x[first];
        fine.expect(end - first);
        fine.add(i, w * x[first] / 2);
        for (int k = first + 1; k < end; ++k) fine.add(rows[k], w * x[k]);
      }
      for (int k = 0; k < fine.size(); ++k) {
        const auto j = static_cast<std::size_t>(fine.index(k));
        coarse.expect(p.begin[j + 1] - p.begin[j]);
        for (auto l = static_cast<std::size_t>(p.begin[j]); l < static_cast<std::size_t>(p.begin[j + 1]); ++l)
          coarse.add(p.column[l], fine.sum(k) * static_cast<double>(p.weight[l]));
      }
      for (int k = 0; k < coarse.size(); ++k) {
        column_.push_back(coarse.index(k));
        value_.push_back(coarse.sum(k));
      }
      fine.clear();
      coarse.clear();
      end_[c + 1] = static_cast<int>(column_.size());
      if (c == n_ / 16) reserve(column_.size() * 18);
    }
  }

  void reserve(std::size_t entries) {
    column_.reserve(entries);
    value_.reserve(entries);
  }

 public:
  /// by_column: the same as p.
  coarse_matrix(const Eigen::SparseMatrix<double>& a, const prolongation& p, const restriction& by_column)
      : n_(static_cast<std::size_t>(p.columns)), end_(n_ + 1), bound_(n_) {
    multiply(a, p, by_column);
  }

  /// P^T A P, once only: T is freed. A diagonal entry that is only rounding errors belongs to the kernel of A, and is replaced by a positive number;
  /// has_kernel: then set.
  Eigen::SparseMatrix<double> lower(bool& has_kernel) {
    Eigen::SparseMatrix<double> r(static_cast<Eigen::Index>(n_), static_cast<Eigen::Index>(n_));  // column c: entries (c, d) and (d, c) of T for d >= c
    std::vector<int> next(n_ + 2);
    const auto for_each_entry = [&](auto visit) {
      for (std::size_t c = 0; c < n_; ++c)
        for (auto k = static_cast<std::size_t>(end_[c]); k < static_cast<std::size_t>(end_[c + 1]); ++k) {
          const auto other = static_cast<std::size_t>(column_[k]);
          visit(std::min(c, other), std::max(c, other), c == other ? 2 * value_[k] : value_[k]);
        }
    };
    for_each_entry([&](std::size_t c, std::size_t, double) { ++next[c + 2]; });
    for (std::size_t i = 2; i < next.size(); ++i) next[i] += next[i - 1];
    r.resizeNonZeros(static_cast<Eigen::Index>(column_.size()));
    for_each_entry([&](std::size_t c, std::size_t d, double x) {
      const int at = next[c + 1]++;
      r.innerIndexPtr()[at] = static_cast<int>(d);
      r.valuePtr()[at] = x;
    });
    for (std::size_t c = 0; c < n_; ++c) r.outerIndexPtr()[c + 1] = next[c + 1];
    std::vector<int>().swap(column_);
    std::vector<double>().swap(value_);
    sort_columns(r);
    add_up_equal_rows(r);
    for (std::size_t c = 0; c < n_; ++c) {
      double& d = r.valuePtr()[r.outerIndexPtr()[c]];
      if (d > 1e-13 * bound_[c]) continue;
      d = bound_[c];
      has_kernel = true;
    }
    return r;
  }
};

}  // namespace concino::detail
