// The choice between a factorisation and an iteration; see auto_solver.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/solve/auto_solver.hpp>
#include <concino/solve/conjugate_gradients.hpp>
#include <concino/solve/ldlt.hpp>

namespace concino {

struct auto_solver::solvers {
  ldlt direct;
  conjugate_gradients iteration;
};

CONCINO_INLINE auto_solver::auto_solver() : auto_solver(auto_solver_options()) {}
CONCINO_INLINE auto_solver::auto_solver(const auto_solver_options& options)
    : options_(options), solvers_(new solvers{ldlt(), conjugate_gradients(options.iteration)}) {
  if (options.max_factor_entries < 0) throw invalid_argument("auto_solver: max_factor_entries is negative");
}
CONCINO_INLINE auto_solver::~auto_solver() = default;

CONCINO_INLINE void auto_solver::factorize(const Eigen::SparseMatrix<double>& a) {
  used_ = solver_used::none;
  if (!solvers_->iteration.has_pattern_of(a) && solvers_->direct.factorize_within(a, options_.max_factor_entries)) {
    used_ = solver_used::ldlt;
  } else {
    solvers_->iteration.factorize(a);
    used_ = solver_used::conjugate_gradients;
  }
}

CONCINO_INLINE void auto_solver::use_order_of(const auto_solver& other) {
  used_ = solver_used::none;
  solvers_->direct.use_order_of(other.solvers_->direct);
}

CONCINO_INLINE Eigen::VectorXd auto_solver::solve(const Eigen::VectorXd& b) const {
  if (used_ == solver_used::none) throw solver_error("auto_solver: solve without a factorised matrix; call factorize first");
  return used_ == solver_used::ldlt ? solvers_->direct.solve(b) : solvers_->iteration.solve(b);
}

CONCINO_INLINE int auto_solver::iterations() const { return is_iterative() ? solvers_->iteration.iterations() : 0; }
CONCINO_INLINE double auto_solver::error() const { return is_iterative() ? solvers_->iteration.error() : 0; }
CONCINO_INLINE double auto_solver::residual() const { return is_iterative() ? solvers_->iteration.residual() : 0; }
CONCINO_INLINE bool auto_solver::has_converged() const { return !is_iterative() || solvers_->iteration.has_converged(); }

}  // namespace concino
