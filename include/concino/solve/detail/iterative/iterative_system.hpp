// What the iterative solvers of symmetric positive definite systems share: checks, order and scale of the matrix, and
// errors.
#pragma once

#include <concino/core/message.hpp>
#include <concino/core/number_text.hpp>
#include <concino/core/system_checks.hpp>
#include <concino/solve/conjugate_gradients_options.hpp>
#include <concino/solve/detail/iterative/incomplete_cholesky.hpp>
#include <concino/solve/detail/iterative/preconditioned_iteration.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Prepares a matrix and its right-hand sides for an iteration: rows are numbered breadth first, and powers of two
/// scale the largest diagonal entry and the largest entry of each right-hand side to [1, 2). `caller` is the name of
/// the solver in messages.
class iterative_system {
  elimination_order order_;
  core::sparsity_pattern pattern_;
  double scale_ = 1;
  Eigen::Index size_ = -1;

 public:
  [[noreturn, gnu::noinline, gnu::cold]] static void throw_missed(const char* caller, const iteration_report& r,
                                                                  double tolerance) {
    core::throw_joined<solver_error>(
        {caller, ": not converged after ", static_cast<std::size_t>(r.iterations),
         " iterations: the error is estimated as ", core::number_text(r.error), " of the solution, the residual is ",
         core::number_text(r.residual), ", the tolerance ", core::number_text(tolerance),
         "; the matrix is not positive definite, or badly conditioned: use ldlt, allow more iterations or a larger"
         " tolerance, or set accept_missed_tolerance"});
  }

  static void check_options(const char* caller, double tolerance, int max_iterations) {
    if (!(tolerance > 0 && tolerance < 1))
      core::throw_joined<invalid_argument>(
          {caller, ": tolerance is ", core::number_text(tolerance), "; it must be in (0, 1)"});
    if (max_iterations < 0) core::throw_joined<invalid_argument>({caller, ": max_iterations is negative"});
  }

  bool has_pattern_of(const Eigen::SparseMatrix<double>& a) const { return a.isCompressed() && pattern_.is_of(a); }

  /// Nothing can be solved until the next call of accept.
  void forget_matrix() { size_ = -1; }

  /// Says that a preconditioner of the prepared matrix exists.
  void accept(Eigen::Index size) { size_ = size; }

  /// The lower triangle of the matrix, checked, reordered and scaled; each column is sorted, so it begins with its
  /// diagonal entry.
  Eigen::SparseMatrix<double> prepare(const char* caller, const Eigen::SparseMatrix<double>& matrix) {
    forget_matrix();
    Eigen::SparseMatrix<double> storage;
    const Eigen::SparseMatrix<double>& input = core::compressed(matrix, storage);
    core::check_square(caller, input);
    core::check_entries(caller, input);
    double largest = 0;
    const std::vector<double> diagonal = core::diagonal(input);
    for (std::size_t i = 0; i < diagonal.size(); ++i) {
      if (!(diagonal[i] > 0))
        throw core::singular_row(
            core::joined({caller, ": the matrix is not positive definite: the diagonal entry of row ", i, " is ",
                          core::number_text(diagonal[i])}),
            static_cast<Eigen::Index>(i));
      largest = std::max(largest, diagonal[i]);
    }
    scale_ = core::power_of_two_to_scale(largest);
    pattern_.update(input, [&](const auto& m) { order_.keep(breadth_first_order(m)); });
    Eigen::SparseMatrix<double> a = order_.lower(input);
    for (Eigen::Index k = 0; k < a.nonZeros(); ++k) a.valuePtr()[k] *= scale_;
    return a;
  }

  /// The lower triangle of the matrix that `prepare` made a of.
  Eigen::SparseMatrix<double> restore(const Eigen::SparseMatrix<double>& a) const {
    const elimination_order inverse{order_.row, order_.position};
    Eigen::SparseMatrix<double> r = inverse.lower(a);
    for (Eigen::Index k = 0; k < r.nonZeros(); ++k) r.valuePtr()[k] /= scale_;
    return r;
  }

  /// a: the prepared matrix; precondition and patience as in preconditioned_iteration; report: about this solve.
  Eigen::VectorXd solve(
      const char* caller, const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& rhs,
      const conjugate_gradients_options& options, std::int64_t patience, iteration_report& report,
      function_ref<bool(const Eigen::VectorXd&, Eigen::VectorXd&, Eigen::VectorXd&)> precondition) const {
    core::check_right_hand_side(caller, rhs, size_);
    report = {};
    double largest = 0;
    for (Eigen::Index i = 0; i < rhs.size(); ++i) largest = std::max(largest, std::abs(rhs[i]));
    Eigen::VectorXd b(size_), x(size_);
    if (!(largest > 0)) {
      for (Eigen::Index i = 0; i < size_; ++i) x[i] = 0;
      return x;
    }
    const double b_scale = core::power_of_two_to_scale(largest);
    const int* const row = order_.row.data();
    for (Eigen::Index i = 0; i < size_; ++i) b[i] = rhs[row[i]] * b_scale;
    preconditioned_iteration iteration(a, options.tolerance, options.max_iterations, patience);
    iteration.run(b, x, precondition);
    report = iteration;
    if (!report.has_converged && !options.accept_missed_tolerance) throw_missed(caller, report, options.tolerance);
    for (Eigen::Index i = 0; i < size_; ++i) b[row[i]] = x[i] * scale_ / b_scale;
    core::check_solution(caller, b);
    return b;
  }
};

}  // namespace concino::detail
