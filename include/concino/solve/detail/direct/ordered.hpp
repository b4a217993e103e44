// A fill-reducing elimination order of a symmetric matrix.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/solve/direct_solver_options.hpp>

#include <Eigen/SparseCore>

#include <vector>

namespace concino::detail {

/// An elimination order, kept for further matrices of the same pattern.
struct elimination_order {
  std::vector<int> position;  // of each row
  std::vector<int> row;       // at each position: the inverse

  /// Stores an order. row_at: the row at each position.
  void keep(std::vector<int> row_at);

  /// Computes the order, by default by approximate minimum degree (Amestoy, Davis, Duff 1996). It depends only on the
  /// pattern of a, which is compressed, in either triangle.
  /// Errors: invalid_argument if `ordering` returns no permutation.
  void find(const Eigen::SparseMatrix<double>& a, elimination_ordering ordering = nullptr);

  /// The upper triangle of the reordered matrix, from the lower one of a, which is compressed.
  Eigen::SparseMatrix<double> operator()(const Eigen::SparseMatrix<double>& a) const;

  /// Its lower triangle, with sorted columns.
  Eigen::SparseMatrix<double> lower(const Eigen::SparseMatrix<double>& a) const;
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/solve/detail/direct/ordered.ipp>
#endif
