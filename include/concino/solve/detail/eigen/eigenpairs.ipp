// Eigenpairs by LOBPCG with multigrid; see eigenpairs.hpp.
#pragma once

#include <concino/core/number_text.hpp>
#include <concino/core/system_checks.hpp>
#include <concino/solve/detail/eigen/lobpcg.hpp>
#include <concino/solve/detail/iterative/incomplete_cholesky.hpp>
#include <concino/solve/eigenpairs.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace concino {

namespace detail {

CONCINO_INLINE void check_lobpcg_options(const lobpcg_options& options) {
  if (!(options.tolerance > 0 && options.tolerance < 1))
    core::throw_joined<invalid_argument>(
        {"eigenpairs: tolerance is ", core::number_text(options.tolerance), "; it must be above 0 and below 1"});
  if (options.max_iterations < 1) throw invalid_argument("eigenpairs: max_iterations must be 1 or more");
  if (!(options.shift >= 0 && std::isfinite(options.shift)))
    core::throw_joined<invalid_argument>(
        {"eigenpairs: shift is ", core::number_text(options.shift), "; it must be finite and 0 or more"});
}

/// The harmonic mean of K_ii / M_ii over the rows where it is positive, divided by their number; 1 if there is none.
/// Few rows with large entries, such as penalties or those of slivers, hardly change it.
CONCINO_INLINE double default_shift(const core::eigenproblem& problem) {
  const std::vector<double> k = core::diagonal(problem.stiffness), m = core::diagonal(problem.mass);
  double sum = 0;
  for (std::size_t i = 0; i < k.size(); ++i)
    if (k[i] > 0) sum += m[i] / k[i];
  return sum > 0 && std::isfinite(1 / sum) ? 1 / sum : 1;
}

/// The pairs that have converged and how far the others are, while the iteration runs.
class convergence_of_pairs {
  Eigen::Index count_;
  double best_ = 0, first_ = 0, fraction_ = 0;
  int since_best_ = 0;
  bool has_begun_ = false;

 public:
  Eigen::Index converged = 0;

  explicit convergence_of_pairs(Eigen::Index count) : count_(count) {}

  bool is_done() const { return converged == count_; }
  /// Whether nothing has improved for a while.
  bool stagnates() const { return since_best_ > 60; }
  double fraction() const { return fraction_; }

  void update(const lobpcg_iteration& iteration) {
    double left = 0;
    converged = 0;
    for (Eigen::Index j = 0; j < count_; ++j) {
      const double ratio = iteration.residuals[j] / iteration.allowed[j];
      if (ratio <= 1) ++converged;
      else left += std::log(ratio);
    }
    if (!has_begun_) best_ = first_ = left;
    has_begun_ = true;
    ++since_best_;
    if (left < 0.98 * best_) {
      best_ = left;
      since_best_ = 0;
    }
    if (first_ > 0) fraction_ = std::clamp(1 - left / first_, fraction_, 1.0);
  }
};

/// Iterates until the first `count` pairs have converged. Then the vectors are made orthonormal anew and measured
/// again.
CONCINO_INLINE convergence_of_pairs converge(lobpcg_iteration& iteration, Eigen::Index count,
                                             const lobpcg_options& options) {
  convergence_of_pairs state(count);
  bool is_fresh = true;  // X is the result of start or restart
  iteration.start();
  for (;;) {
    iteration.measure();
    state.update(iteration);
    report_progress(options.progress, state.fraction(), "eigenpairs");
    const bool must_stop = state.is_done() || state.stagnates() ||
                           iteration.iterations >= static_cast<std::size_t>(options.max_iterations);
    if (!must_stop && iteration.improve()) {
      is_fresh = false;
      continue;
    }
    if (is_fresh) return state;
    iteration.restart();
    is_fresh = true;
  }
}

[[noreturn, gnu::noinline, gnu::cold]] CONCINO_INLINE void throw_pairs_missed(const lobpcg_iteration& iteration,
                                                                              const convergence_of_pairs& state,
                                                                              Eigen::Index count, double tolerance) {
  double worst = 0;
  for (Eigen::Index j = 0; j < count; ++j)
    if (!(iteration.residuals[j] <= iteration.allowed[j]))
      worst = std::max(worst, iteration.residuals[j] / iteration.values[j]);
  core::throw_joined<solver_error>(
      {"eigenpairs: ", static_cast<std::size_t>(state.converged), " of ", static_cast<std::size_t>(count),
       " have converged after ", iteration.iterations, " iterations; residuals are up to ", core::number_text(worst),
       " of the eigenvalue plus the shift, the tolerance is ", core::number_text(tolerance),
       ": allow more iterations or a larger tolerance, or set accept_missed_tolerance"});
}

/// The levels of K + shift M, and M, with rows numbered breadth first. The stiffness of the problem is freed.
class shifted_levels {
 public:
  elimination_order order;
  multigrid_levels levels;
  Eigen::SparseMatrix<double> mass;

  shifted_levels(core::eigenproblem& problem, double shift) {
    Eigen::SparseMatrix<double> a = problem.stiffness + shift * problem.mass;
    Eigen::SparseMatrix<double>().swap(problem.stiffness);
    const std::vector<double> diagonal = core::diagonal(a);
    for (std::size_t i = 0; i < diagonal.size(); ++i)
      if (!(diagonal[i] > 0))
        core::throw_joined<solver_error>(
            {"eigenpairs: the matrix is not positive semidefinite: the diagonal entry of row ",
             static_cast<std::size_t>(problem.row[i]), " is negative; give it the other sign if it is a Laplacian"});
    order.keep(breadth_first_order(a));
    order.lower(a).swap(a);
    order.lower(problem.mass).swap(mass);
    levels.build(a);
  }
};

/// The smallest pairs of the problem, from an iteration with `size` vectors. rows: of the input matrices.
CONCINO_INLINE eigenpairs_result iterate_for_pairs(core::eigenproblem& problem, Eigen::Index size, Eigen::Index count,
                                                   Eigen::Index rows, const lobpcg_options& options) {
  const double shift = options.shift > 0 ? problem.scaled(options.shift) : default_shift(problem);
  const shifted_levels matrices(problem, shift);
  core::eigenbasis found;
  Eigen::VectorXd residuals;
  std::size_t iterations = 0;
  bool has_converged = true;
  {
    lobpcg_iteration iteration(matrices.levels, matrices.mass, size, options.tolerance);
    const convergence_of_pairs state = converge(iteration, count, options);
    has_converged = state.is_done();
    if (!has_converged && !options.accept_missed_tolerance)
      throw_pairs_missed(iteration, state, count, options.tolerance);
    std::vector<Eigen::Index> column(static_cast<std::size_t>(count));
    for (std::size_t j = 0; j < column.size(); ++j) column[j] = static_cast<Eigen::Index>(j);
    std::stable_sort(column.begin(), column.end(),
                     [&](Eigen::Index i, Eigen::Index j) { return iteration.values[i] < iteration.values[j]; });
    found.vectors = iteration.vectors(column);
    found.solves = iteration.cycles;
    found.values.resize(count);
    residuals.resize(count);
    for (Eigen::Index j = 0; j < count; ++j) {
      found.values[j] = iteration.values[column[static_cast<std::size_t>(j)]] - shift;
      residuals[j] = iteration.residuals[column[static_cast<std::size_t>(j)]];
    }
    iterations = iteration.iterations;
  }
  eigenpairs_result r = problem.result(found, residuals, rows, matrices.order.position);
  r.iterations = iterations;
  r.has_converged = has_converged;
  return r;
}

}  // namespace detail

CONCINO_INLINE eigenpairs_result eigenpairs(const Eigen::SparseMatrix<double>& k, const Eigen::SparseMatrix<double>& m,
                                            std::size_t count, lobpcg_method, const lobpcg_options& input_options) {
  const core::profiled_options profiled(input_options, "eigenpairs");
  const lobpcg_options& options = *profiled;
  detail::check_lobpcg_options(options);
  core::eigenproblem problem(k, m);
  const std::size_t rows = problem.row.size();
  if (count < 1 || count > rows) core::throw_bad_eigenpair_count(count, rows);
  detail::report_progress(options.progress, 0, "eigenpairs");
  // some more converge faster than the wanted ones alone
  const std::size_t size = (count + std::max<std::size_t>(3, count / 8) + 7) / 8 * 8;
  if (rows >= 256 && rows >= 5 * size)
    return detail::iterate_for_pairs(problem, static_cast<Eigen::Index>(size), static_cast<Eigen::Index>(count),
                                     k.rows(), options);
  const core::eigenbasis found = core::dense_eigenpairs(problem, count);
  return problem.result(found, core::eigen_residuals(problem, found), k.rows());
}

}  // namespace concino
