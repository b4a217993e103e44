// An iterative solver for square sparse systems of any kind that are too large for a factorisation.
#pragma once

#include <concino/core/equilibrate.hpp>
#include <concino/core/number_text.hpp>
#include <concino/solve/checked_solver.hpp>

#include <Eigen/IterativeLinearSolvers>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace concino {

struct bicgstab_options {
  double tolerance = 1e-12;    // of the residual, see bicgstab; in (0, 1)
  int max_iterations = 0;      // 0: twice the number of unknowns
  double drop = 1e-4;          // smaller entries of the incomplete factors, relative to their row, are dropped; in [0,
                               // 1)
  int fill = 10;               // maximal entries of the incomplete factors, as a multiple of those of the matrix;
                               // positive
  bool accept_missed_tolerance = false;  // true: solve returns the best result so far; has_converged() says whether it
                                         // meets the tolerance
};

/// Solves square systems, symmetric or not, by stabilised bi-conjugate gradients, with an incomplete LU factorisation
/// as preconditioner. A SparseSolver with memory proportional to the entries of the matrix. Reads the whole matrix,
/// also both triangles of a symmetric one. Rows and columns are scaled by powers of two first. `factorize` stores a
/// scaled copy of the matrix and the preconditioner; no analysis is reused. residual() is the largest of three numbers:
/// |b - A x| / |b| of the scaled system, and the largest |b - A x|_i / (|b|_i + max_j |a_ij| max|x|) of all rows i, of
/// the original and of the scaled system. Large entries of some rows, such as penalties, do not hide the others. A
/// small residual of a badly conditioned system does not mean a small error. If rounding errors allow no better,
/// residuals of single rows of at most 1e-14 are accepted if |b - A x| / |b| is at most 1e-6. Solutions so large that b
/// is within the rounding errors of A x are never accepted. iterations(), residual() and has_converged() describe the
/// last solve. So one object must not solve in several threads at once.
/// Errors: invalid_argument if an option is out of its range. factorize throws solver_error, with the reason, if the
///         matrix is not square, or has entries that are not finite, or a row or column of zeros. solve throws it if
///         nothing was factorised, or the right-hand side has another size or is not finite. solve also throws it if
///         the tolerance is missed, after max_iterations or because the iteration stagnates or breaks down; the message
///         contains iterations, residual and tolerance. Singular matrices fail in this way, unless the iteration finds
///         a solution for that right-hand side.
/// Source: van der Vorst 1992; Saad 1994; Eigen's BiCGSTAB and IncompleteLUT.
class bicgstab {
  bicgstab_options options_;
  Eigen::SparseMatrix<double> a_;  // the iteration refers to it
  core::equilibration scale_;
  std::vector<double> entry_, entry_in_units_;  // the largest of each row; and divided by the scale of its column
  mutable Eigen::BiCGSTAB<Eigen::SparseMatrix<double>, Eigen::IncompleteLUT<double>> iteration_;
  mutable std::int64_t iterations_ = 0;
  mutable double residual_ = 0;
  mutable bool has_converged_ = true;
  checked_solver checks_{"bicgstab"};

 public:
  static constexpr bool reads_both_triangles = true;

  bicgstab() = default;
  explicit bicgstab(const bicgstab_options& options) : options_(options) {
    if (!(options.tolerance > 0 && options.tolerance < 1))
      core::throw_joined<invalid_argument>(
          {"bicgstab: tolerance is ", core::number_text(options.tolerance), "; it must be in (0, 1)"});
    if (!(options.drop >= 0 && options.drop < 1))
      core::throw_joined<invalid_argument>(
          {"bicgstab: drop is ", core::number_text(options.drop), "; it must be in [0, 1)"});
    if (options.max_iterations < 0) throw invalid_argument("bicgstab: max_iterations is negative");
    if (options.fill < 1) throw invalid_argument("bicgstab: fill is not positive");
  }

  void factorize(const Eigen::SparseMatrix<double>& matrix) {
    Eigen::SparseMatrix<double> storage;
    a_ = checks_.begin_square(matrix, storage);
    a_.prune([](Eigen::Index, Eigen::Index, double x) { return x != 0; });
    scale_ = core::equilibrate(a_);
    check_rows_and_columns();
    find_largest_entries();
    if (a_.cols() > 0) {
      iteration_.preconditioner().setDroptol(options_.drop);
      iteration_.preconditioner().setFillfactor(options_.fill);
      iteration_.compute(a_);
      if (iteration_.info() != Eigen::Success)
        throw solver_error("bicgstab: the incomplete LU factorisation failed; the matrix is singular");
    }
    checks_.accept(a_.rows());
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& right) const {
    iterations_ = 0;
    residual_ = 0;
    has_converged_ = true;
    return checks_.solve(right, [&](const Eigen::VectorXd& rhs) { return solve_scaled(rhs); });
  }

  const bicgstab_options& options() const { return options_; }
  static constexpr bool is_iterative() { return true; }
  int iterations() const { return static_cast<int>(iterations_); }
  double residual() const { return residual_; }
  bool has_converged() const { return has_converged_; }

 private:
  Eigen::VectorXd solve_scaled(const Eigen::VectorXd& rhs) const {
    if (rhs.isZero(0)) return Eigen::VectorXd::Zero(a_.rows());
    Eigen::VectorXd b = core::scaled(rhs, scale_.rows);
    const double b_scale = core::power_of_two_to_scale(b.cwiseAbs().maxCoeff());
    b *= b_scale;
    Eigen::VectorXd x = iterate(b);
    if (!has_converged_ && !options_.accept_missed_tolerance)
      core::throw_joined<solver_error>(
          {"bicgstab: not converged after ", static_cast<std::size_t>(iterations_), " iterations: the residual is ",
           core::number_text(residual_), ", the tolerance ", core::number_text(options_.tolerance),
           "; the matrix is singular or badly conditioned: use lu, allow more iterations, more fill or a larger"
           " tolerance, or set accept_missed_tolerance"});
    return core::scaled(std::move(x), scale_.columns) / b_scale;
  }

  /// Solves repeatedly for the remainder while that halves the residual. The iteration only estimates the residual, and
  /// may stagnate or break down unnoticed.
  Eigen::VectorXd iterate(const Eigen::VectorXd& b) const {
    const std::int64_t most =
        options_.max_iterations > 0 ? options_.max_iterations : 2 * static_cast<std::int64_t>(a_.rows());
    const auto at_a_time = 500 + 4 * static_cast<std::int64_t>(std::sqrt(static_cast<double>(a_.rows())));
    Eigen::VectorXd x = Eigen::VectorXd::Zero(a_.rows()), r = b;
    residual_ = 1;
    has_converged_ = false;
    for (bool helps = true; helps && residual_ > options_.tolerance && iterations_ < most;) {
      iteration_.setTolerance(std::clamp(options_.tolerance / residual_ / 2, options_.tolerance, 0.1));
      iteration_.setMaxIterations(static_cast<Eigen::Index>(std::min(most - iterations_, at_a_time)));
      const Eigen::VectorXd better = x + iteration_.solve(r);
      iterations_ += iteration_.iterations();
      if (!better.allFinite()) break;
      const Eigen::VectorXd rest = b - a_ * better;
      const double of_rows = largest_residual(rest, b, better), reached = std::max(of_rows, rest.norm() / b.norm());
      helps = reached < residual_ / 2;
      if (!(reached < residual_)) break;
      x = better;
      r = rest;
      residual_ = reached;
      const double rounding =
          std::numeric_limits<double>::epsilon() * better.cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
      has_converged_ = (reached <= options_.tolerance || (of_rows <= 1e-14 && reached <= 1e-6)) && rounding <= 1e-6;
    }
    return x;
  }

  /// The residual of the scaled system.
  double largest_residual(const Eigen::VectorXd& r, const Eigen::VectorXd& b, const Eigen::VectorXd& x) const {
    double largest = 0, largest_in_units = 0, worst = 0;
    for (Eigen::Index i = 0; i < a_.rows(); ++i) {
      largest = std::max(largest, std::abs(x[i]));
      largest_in_units = std::max(largest_in_units, std::abs(x[i]) * scale_.columns[static_cast<std::size_t>(i)]);
    }
    for (Eigen::Index i = 0; i < a_.rows(); ++i) {
      const auto row = static_cast<std::size_t>(i);
      const double allowed = std::abs(b[i]) + std::min(entry_[row] * largest, entry_in_units_[row] * largest_in_units);
      const double e = r[i] == 0 ? 0 : std::abs(r[i]) / allowed;
      if (e > worst || std::isnan(e)) worst = e;
    }
    return worst;
  }

  void find_largest_entries() {
    entry_.assign(static_cast<std::size_t>(a_.rows()), 0);
    entry_in_units_ = entry_;
    for (int c = 0; c < a_.cols(); ++c)
      for (int k = a_.outerIndexPtr()[c]; k < a_.outerIndexPtr()[c + 1]; ++k) {
        const auto row = static_cast<std::size_t>(a_.innerIndexPtr()[k]);
        const double size = std::abs(a_.valuePtr()[k]);
        entry_[row] = std::max(entry_[row], size);
        entry_in_units_[row] = std::max(entry_in_units_[row], size / scale_.columns[static_cast<std::size_t>(c)]);
      }
  }

  void check_rows_and_columns() const {
    std::vector<char> row_has(static_cast<std::size_t>(a_.rows()));
    for (Eigen::Index k = 0; k < a_.nonZeros(); ++k) row_has[static_cast<std::size_t>(a_.innerIndexPtr()[k])] = 1;
    for (std::size_t i = 0; i < row_has.size(); ++i) {
      if (!row_has[i]) core::throw_joined<solver_error>({"bicgstab: the matrix is singular: row ", i, " is 0"});
      if (a_.outerIndexPtr()[i] == a_.outerIndexPtr()[i + 1])
        core::throw_joined<solver_error>({"bicgstab: the matrix is singular: column ", i, " is 0"});
    }
  }
};

}  // namespace concino
