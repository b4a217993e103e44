// Checks of matrices, right-hand sides and solutions, shared by all solvers. One compares the sparsity pattern of a
// matrix with the previous one.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/error.hpp>

#include <Eigen/SparseCore>

#include <cstddef>
#include <string>
#include <vector>

namespace concino::core {

/// The matrix itself if it is compressed, or a compressed copy in `storage`.
const Eigen::SparseMatrix<double>& compressed(const Eigen::SparseMatrix<double>& a,
                                              Eigen::SparseMatrix<double>& storage);

void check_square(const char* caller, const Eigen::SparseMatrix<double>& a);

/// a: compressed.
void check_entries(const char* caller, const Eigen::SparseMatrix<double>& a);

/// rows: of the last factorised matrix; -1: none.
void check_right_hand_side(const char* caller, const Eigen::VectorXd& b, Eigen::Index rows);

void check_solution(const char* caller, const Eigen::VectorXd& x);

/// A solver_error with the row in which elimination stopped, for callers who know the meaning of that row.
struct singular_row : solver_error {
  Eigen::Index row;
  singular_row(const std::string& what, Eigen::Index in_row) : solver_error(what), row(in_row) {}
};

/// `diagonal`: the diagonal entry, or another number with which the pivot is compared.
[[noreturn, gnu::cold]] void throw_bad_pivot(const char* caller, const char* what, Eigen::Index row, double diagonal,
                                             double pivot);

/// The diagonal of a compressed matrix; 0 where it has no entry.
std::vector<double> diagonal(const Eigen::SparseMatrix<double>& a);

/// The positions of the entries of a matrix. They alone determine the elimination order and whether it can be reused.
/// Comparing costs far less than ordering.
class sparsity_pattern {
  std::vector<int> starts_, rows_;
  Eigen::Index height_ = -1;

 public:
  void invalidate() { height_ = -1; }

  /// a: compressed, as below.
  void remember(const Eigen::SparseMatrix<double>& a);

  bool is_of(const Eigen::SparseMatrix<double>& a) const;

  /// Analyses a by `analyse(a)` unless it has this pattern already.
  template<class F>
  void update(const Eigen::SparseMatrix<double>& a, F analyse) {
    if (is_of(a)) return;
    invalidate();  // in case analyse throws
    analyse(a);
    remember(a);
  }
};

/// 2^k with 2^k x in [1, 2), for scaling without rounding; 1 for 0 and if 2^k would not be a normal number.
double power_of_two_to_scale(double x);

}  // namespace concino::core

#ifndef CONCINO_COMPILED
#include <concino/core/detail/system_checks.ipp>
#endif
