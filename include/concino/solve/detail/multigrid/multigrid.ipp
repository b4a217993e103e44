// Conjugate gradients with multigrid; see multigrid.hpp.
#pragma once

#include <concino/solve/multigrid.hpp>

#include <cstdint>

namespace concino {

CONCINO_INLINE multigrid::multigrid(const multigrid_options& options) : options_(options) {
  detail::iterative_system::check_options("multigrid", options.tolerance, options.max_iterations);
}

CONCINO_INLINE void multigrid::factorize(const Eigen::SparseMatrix<double>& matrix) {
  Eigen::SparseMatrix<double> a = system_.prepare("multigrid", matrix);
  levels_.build(a);
  system_.accept(matrix.cols());
}

CONCINO_INLINE Eigen::VectorXd multigrid::solve(const Eigen::VectorXd& rhs) const {
  constexpr std::int64_t patience = 100;
  const Eigen::SparseMatrix<double> none;
  detail::multigrid_levels::workspace work = levels_.make_workspace();
  return system_.solve("multigrid", levels_.size() > 0 ? levels_.finest() : none, rhs,
                       {options_.tolerance, options_.max_iterations, options_.accept_missed_tolerance}, patience,
                       report_, [&](const Eigen::VectorXd& r, Eigen::VectorXd& z, Eigen::VectorXd& y) {
                         return levels_.apply(r.data(), z.data(), y.data(), work);
                       });
}

}  // namespace concino
