// Checks that direct solvers share: of matrices, right-hand sides and solutions.
#pragma once

#include <concino/core/system_checks.hpp>

#include <Eigen/SparseCore>

namespace concino {

/// What a direct solver does beside its numerical work. A solver holds one, and calls begin, analyse_once and accept in
/// `factorize`:
///   Eigen::SparseMatrix<double> storage;
///   const Eigen::SparseMatrix<double>& a = checks_.begin_square(matrix, storage);
///   checks_.analyse_once(a, [&](const auto& m) { factors_.analyzePattern(m); });
///   factors_.factorize(a);
///   checks_.accept(a.rows());
/// Until accept is called nothing is factorised, whatever was thrown in between.
/// Errors: solver_error if a matrix has entries that are not finite or is not square; in solve, if nothing was
///         factorised, the right-hand side has another size, or an entry of it or of the solution is not finite.
///         Messages begin with the name of the solver.
class checked_solver {
  const char* name_;
  core::sparsity_pattern pattern_;
  Eigen::Index rows_ = -1;

 public:
  /// name: must outlive this object.
  explicit checked_solver(const char* name) : name_(name) {}

  const char* name() const { return name_; }

  /// Checks the entries of a matrix, and returns it, or a compressed copy in `storage`.
  const Eigen::SparseMatrix<double>& begin(const Eigen::SparseMatrix<double>& matrix,
                                           Eigen::SparseMatrix<double>& storage) {
    rows_ = -1;
    const Eigen::SparseMatrix<double>& a = core::compressed(matrix, storage);
    core::check_entries(name_, a);
    return a;
  }
  const Eigen::SparseMatrix<double>& begin_square(const Eigen::SparseMatrix<double>& matrix,
                                                  Eigen::SparseMatrix<double>& storage) {
    rows_ = -1;
    core::check_square(name_, matrix);
    return begin(matrix, storage);
  }

  /// Calls analyse(a) unless a has the pattern of the previous matrix, explicit zeros included.
  template<class F>
  void analyse_once(const Eigen::SparseMatrix<double>& a, F analyse) {
    pattern_.update(a, analyse);
  }
  /// The next matrix is compared with the pattern of another solver, whose analysis this one has taken over.
  void use_pattern_of(const checked_solver& other) {
    rows_ = -1;
    pattern_ = other.pattern_;
  }
  void forget_pattern() {
    rows_ = -1;
    pattern_.invalidate();
  }

  void accept(Eigen::Index rows) { rows_ = rows; }

  /// compute(b), checked.
  template<class F>
  Eigen::VectorXd solve(const Eigen::VectorXd& b, F compute) const {
    core::check_right_hand_side(name_, b, rows_);
    if (rows_ == 0) return Eigen::VectorXd(0);
    Eigen::VectorXd x = compute(b);
    core::check_solution(name_, x);
    return x;
  }
};

}  // namespace concino
