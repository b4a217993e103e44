// The iteration of conjugate gradients; see conjugate_gradients.hpp.
#pragma once

#include <concino/solve/conjugate_gradients.hpp>

#include <cmath>
#include <cstdint>

namespace concino {

CONCINO_INLINE conjugate_gradients::conjugate_gradients(const conjugate_gradients_options& options)
    : options_(options) {
  detail::iterative_system::check_options("conjugate_gradients", options.tolerance, options.max_iterations);
}

CONCINO_INLINE void conjugate_gradients::factorize(const Eigen::SparseMatrix<double>& matrix) {
  a_ = system_.prepare("conjugate_gradients", matrix);
  preconditioner_.factorize(a_);
  system_.accept(a_.cols());
}

CONCINO_INLINE Eigen::VectorXd conjugate_gradients::solve(const Eigen::VectorXd& rhs) const {
  const std::int64_t patience = 500 + 4 * static_cast<std::int64_t>(std::sqrt(static_cast<double>(a_.cols())));
  return system_.solve("conjugate_gradients", a_, rhs, options_, patience, report_,
                       [&](const Eigen::VectorXd& r, Eigen::VectorXd& z, Eigen::VectorXd&) {
                         return preconditioner_.solve(a_, r, z), false;
                       });
}

}  // namespace concino
