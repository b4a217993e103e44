// A direct solver for square sparse systems of any kind, by LU factorisation.
#pragma once

#include <concino/core/equilibrate.hpp>
#include <concino/solve/checked_solver.hpp>

#include <Eigen/SparseLU>

#include <algorithm>
#include <cstdlib>
#include <string>

namespace concino {

/// Factorises a square matrix, symmetric or not, as L U with row exchanges and a fill-reducing order, and solves with
/// it. A SparseSolver. Reads the whole matrix, also both triangles of a symmetric one. Rows and columns are scaled by
/// powers of two first, to entries near 1, so that unknowns and equations may have different units. A matrix with the
/// pattern of the previously factorised one reuses its order.
/// Errors: factorize throws solver_error, with the reason, if the matrix is not square, has entries that are not
///         finite, or is singular to working precision, that is, its condition number exceeds about 1e13. Then the
///         message names a column that depends on others: an undetermined unknown. solve throws it if nothing was
///         factorised, the right-hand side has another size, or an entry of it or of the solution is not finite. After
///         a failed factorize, nothing is factorised.
/// Source: Eigen's SparseLU (Demmel, Eisenstat, Gilbert, Li, Liu 1999) with column approximate minimum degree ordering
///         (Davis et al. 2004).
class lu {
  using factors = Eigen::SparseLU<Eigen::SparseMatrix<double>, Eigen::COLAMDOrdering<int>>;
  factors factors_;
  checked_solver checks_{"lu"};
  core::equilibration scale_;

 public:
  static constexpr bool reads_both_triangles = true;

  void factorize(const Eigen::SparseMatrix<double>& matrix) {
    Eigen::SparseMatrix<double> storage, a;
    a = checks_.begin_square(matrix, storage);  // Eigen's copy constructor leaks if memory runs out
    scale_ = core::equilibrate(a);
    if (a.cols() > 0) {
      check_columns(a);
      checks_.analyse_once(a, [&](const auto& m) { factors_.analyzePattern(m); });
      factors_.factorize(a);
      check_factors();
    }
    checks_.accept(a.rows());
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& right) const {
    return checks_.solve(right, [&](const Eigen::VectorXd& b) {
      const Eigen::VectorXd x = factors_.solve(core::scaled(b, scale_.rows));
      return core::scaled(x, scale_.columns);
    });
  }

 private:
  [[noreturn]] static void throw_singular(Eigen::Index column, const char* because) {
    core::throw_joined<solver_error>({"lu: the matrix is singular in column ", static_cast<std::size_t>(column),
                                      ": it ", because, ", so that this unknown is not determined"});
  }

  static void check_columns(const Eigen::SparseMatrix<double>& a) {
    for (int c = 0; c < a.cols(); ++c) {
      bool any = false;
      for (int k = a.outerIndexPtr()[c]; k < a.outerIndexPtr()[c + 1]; ++k) any |= a.valuePtr()[k] != 0;
      if (!any) throw_singular(c, "is 0");
    }
  }

  void check_factors() const {
    const char* const depends = "is a combination of others to working precision";
    if (factors_.info() != Eigen::Success) {
      const std::string message = factors_.lastErrorMessage();  // ends with the position of the column, from 1
      const auto digits = message.find_last_not_of("0123456789") + 1;
      if (digits == message.size())
        core::throw_joined<solver_error>({"lu: the matrix cannot be factorised: ", message});
      const long pivot = std::atol(message.c_str() + digits) - 1;
      const auto& column_order = factors_.colsPermutation().indices();
      throw_singular(
          std::find(column_order.data(), column_order.data() + column_order.size(), pivot) - column_order.data(),
          depends);
    }
    // Pivots that should be 0 appear as rounding errors. Two steps of inverse iteration grow by 1 over the smallest
    // singular value.
    Eigen::VectorXd x(factors_.cols());
    for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = 1 + static_cast<double>(i * 7919 % 101) / 101;
    double growth = 0;
    for (int step = 0; step < 3; ++step) {
      x /= x.norm();
      x = step == 1 ? Eigen::VectorXd(const_cast<factors&>(factors_).transpose().solve(x))
                    : Eigen::VectorXd(factors_.solve(x));
      growth = x.norm();
      if (!(growth < 1e13)) break;
    }
    Eigen::Index largest = 0;
    if (!(growth < 1e13)) {
      x.cwiseAbs().maxCoeff(&largest);
      throw_singular(largest, depends);
    }
  }
};

}  // namespace concino
