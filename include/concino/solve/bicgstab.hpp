// Square sparse systems of any kind by iteration: what is too large for a factorisation.
#pragma once

#include <concino/solve/detail/equilibrate.hpp>
#include <concino/solve/detail/system_checks.hpp>

#include <Eigen/IterativeLinearSolvers>

#include <algorithm>
#include <utility>
#include <vector>

namespace concino {

struct bicgstab_options {
  double tolerance = 1e-12;    // of |b - a x| / |b|, rows and columns scaled to entries near 1; in (0, 1)
  int max_iterations = 0;      // 0: twice as many as there are unknowns
  double drop = 1e-4;          // entries of the incomplete factors that are smaller, relative to their row, are left out; in [0, 1)
  int fill = 10;               // at most so many times the entries of the matrix in the incomplete factors; positive
};

/// Solves square systems, symmetric or not, by stabilised bi-conjugate gradients, with an incomplete LU factorisation to speed them up. A
/// SparseSolver of memory proportional to the entries of the matrix. The whole matrix is read, both triangles of a symmetric one too. Rows and
/// columns are scaled by powers of two first. `factorize` keeps a scaled copy of the matrix and prepares: there is no analysis to save.
/// iterations() and residual(), |b - a x| / |b| of the scaled system, tell of the last solve; therefore not for several threads at once.
/// Errors: invalid_argument if an option is out of its range; solver_error, with the reason, from factorize if the matrix is not square, has
///         entries that are not finite, or a row or column of zeros; from solve if nothing was factorised, or the right-hand side has another
///         size or is not finite, or the iteration has not converged: n iterations and residual r are named. Singular matrices end so,
///         unless the right-hand side lets the iteration find a solution. Where rounding errors hide what the last iterations gain, residuals
///         of up to 1e-6 are let pass; residual() tells.
/// Source: van der Vorst 1992; Saad 1994; Eigen's BiCGSTAB and IncompleteLUT.
class bicgstab {
  bicgstab_options options_;
  Eigen::SparseMatrix<double> a_;  // the iteration refers to it
  detail::equilibration scale_;
  Eigen::BiCGSTAB<Eigen::SparseMatrix<double>, Eigen::IncompleteLUT<double>> iteration_;
  mutable int iterations_ = 0;
  mutable double residual_ = 0;
  Eigen::Index size_ = -1;

 public:
  static constexpr bool reads_both_triangles = true;

  bicgstab() = default;
  explicit bicgstab(const bicgstab_options& options) : options_(options) {
    if (!(options.tolerance > 0 && options.tolerance < 1))
      detail::throw_joined<invalid_argument>({"bicgstab: tolerance is ", detail::number_text(options.tolerance), "; it must be in (0, 1)"});
    if (!(options.drop >= 0 && options.drop < 1))
      detail::throw_joined<invalid_argument>({"bicgstab: drop is ", detail::number_text(options.drop), "; it must be in [0, 1)"});
    if (options.max_iterations < 0) throw invalid_argument("bicgstab: max_iterations is negative");
    if (options.fill < 1) throw invalid_argument("bicgstab: fill is not positive");
  }

  void factorize(const Eigen::SparseMatrix<double>& given) {
    size_ = -1;
    a_ = given;
    a_.makeCompressed();
    detail::check_square("bicgstab", a_);
    detail::check_entries("bicgstab", a_);
    a_.prune([](Eigen::Index, Eigen::Index, double x) { return x != 0; });
    scale_ = detail::equilibrate(a_);
    check_rows_and_columns();
    if (a_.cols() > 0) {
      iteration_.preconditioner().setDroptol(options_.drop);
      iteration_.preconditioner().setFillfactor(options_.fill);
      iteration_.compute(a_);
      if (iteration_.info() != Eigen::Success) throw solver_error("bicgstab: the incomplete LU factorisation failed; the matrix is singular");
      iteration_.setTolerance(options_.tolerance);
      iteration_.setMaxIterations(options_.max_iterations > 0 ? options_.max_iterations : 2 * a_.cols());
    }
    size_ = a_.rows();
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& given) const {
    detail::check_right_hand_side("bicgstab", given, size_);
    iterations_ = 0;
    residual_ = 0;
    if (given.isZero(0)) return Eigen::VectorXd::Zero(size_);
    Eigen::VectorXd b = detail::scaled(given, scale_.rows);
    const double b_scale = detail::power_of_two_to_scale(b.cwiseAbs().maxCoeff());
    b *= b_scale;
    Eigen::VectorXd x = iteration_.solve(b);
    iterations_ = static_cast<int>(iteration_.iterations());
    residual_ = (b - a_ * x).norm() / b.norm();  // the iteration's own is only estimated
    if (iteration_.info() != Eigen::Success || !(residual_ <= std::max(options_.tolerance, 1e-6)))
      detail::throw_joined<solver_error>({"bicgstab: not converged after ", static_cast<std::size_t>(iterations_), " iterations: the residual is ",
                                          detail::number_text(residual_), ", the tolerance ", detail::number_text(options_.tolerance),
                                          "; the matrix is singular or badly conditioned"});
    x = detail::scaled(std::move(x), scale_.columns) / b_scale;
    detail::check_solution("bicgstab", x);
    return x;
  }

  const bicgstab_options& options() const { return options_; }
  static constexpr bool iterates() { return true; }
  int iterations() const { return iterations_; }
  double residual() const { return residual_; }

 private:
  void check_rows_and_columns() const {
    std::vector<char> row_has(static_cast<std::size_t>(a_.rows()));
    for (Eigen::Index k = 0; k < a_.nonZeros(); ++k) row_has[static_cast<std::size_t>(a_.innerIndexPtr()[k])] = 1;
    for (std::size_t i = 0; i < row_has.size(); ++i) {
      if (!row_has[i]) detail::throw_joined<solver_error>({"bicgstab: the matrix is singular: row ", i, " is 0"});
      if (a_.outerIndexPtr()[i] == a_.outerIndexPtr()[i + 1])
        detail::throw_joined<solver_error>({"bicgstab: the matrix is singular: column ", i, " is 0"});
    }
  }
};

}  // namespace concino
