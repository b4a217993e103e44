// The default solver: multigrid or a factorisation, whichever takes less time.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/solve/multigrid_options.hpp>

#include <Eigen/SparseCore>

#include <cstdint>
#include <memory>

namespace concino {

struct auto_solver_options {
  std::int64_t max_factor_entries = 100'000'000;  // below the diagonal, 12 bytes each; at least 0; a larger factor is not computed
  std::int64_t questions = 0;                     // right-hand sides expected for each matrix; 0: unknown
  multigrid_options iteration = {};               // of the solves by multigrid
};

enum class solver_used { none, ldlt, multigrid };

/// CPU seconds on one core of a server of 2023, as a model predicts them.
struct predicted_times {
  double factorize = 0;  // with the order of the unknowns
  double solve = 0;      // for one right-hand side
};

/// Solves symmetric systems by ldlt or by multigrid, whichever takes less time by a model of both. A SparseSolver; the default of all problems. Reads only
/// the lower triangle. A single solve on a mesh of more than about 20,000 verts is by multigrid, on a smaller surface by ldlt. Narrow bands and trees are
/// factorised whatever their size. If `questions` right-hand sides are expected, the choice is that for all of them. If their number is unknown, multigrid
/// answers the first ones, and ldlt the others, as soon as multigrid has cost as much as a factor. That is at most about twice the time of the better of both.
/// The choice depends on the matrix, the options and the solves so far, not on measured times: results are reproducible.
/// A factor has at most max_factor_entries. They are counted before it is computed. Where it may be computed, multigrid never fails: a matrix that is not
/// positive definite, or a solve that misses the tolerance, goes to ldlt. Then errors are those of ldlt.
/// Give it a name to learn what it did: auto_solver s; harmonic_map(m, values, {}, s). Then s.used() names the method for the next solve, and s.predicted
/// the times. s.iterations(), s.error(), s.residual() and s.has_converged() describe the last solve by multigrid; for ldlt they are 0, 0, 0 and true. By
/// multigrid, values far smaller than the largest have no correct digits. A matrix with the pattern of the previous one reuses its order.
/// Several threads may solve at once. Those that multigrid answers take turns, and which of them it answers may depend on their order.
/// Errors: as ldlt and as multigrid; their messages begin with their names. invalid_argument if an option is out of its range.
class auto_solver {
  struct state;  // both solvers, which take long to compile
  auto_solver_options options_;
  std::unique_ptr<state> state_;

 public:
  auto_solver();
  explicit auto_solver(const auto_solver_options& options);
  auto_solver(const auto_solver&) = delete;
  auto_solver& operator=(const auto_solver&) = delete;
  ~auto_solver();

  void factorize(const Eigen::SparseMatrix<double>& a);

  /// Copies the elimination order of another solver, see ldlt; none if that used multigrid only.
  void use_order_of(const auto_solver& other);

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

  const auto_solver_options& options() const { return options_; }
  /// The method that factorize or the last solve chose; none before the first factorize, and after one that failed.
  solver_used used() const;
  bool is_iterative() const { return used() == solver_used::multigrid; }
  /// What this method costs for the last matrix. Of ldlt: NaN if its factor was not counted, because multigrid costs less in any case; infinity if it would be
  /// too large.
  predicted_times predicted(solver_used method) const;
  int iterations() const;
  double error() const;
  double residual() const;
  bool has_converged() const;
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/solve/detail/auto_solver.ipp>
#endif
