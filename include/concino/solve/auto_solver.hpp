// The default solver: a factorisation of small systems, multigrid for large ones.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/solve/multigrid_options.hpp>

#include <Eigen/SparseCore>

#include <cstdint>
#include <memory>

namespace concino {

struct auto_solver_options {
  std::int64_t max_factor_entries = 100'000'000;  // below the diagonal, 12 bytes each; at least 0; a larger factor is
                                                  // not computed
  std::int64_t questions = 1;                     // right-hand sides expected for each matrix, at least 1; 10 and more
                                                  // are many
  multigrid_options iteration = {};               // of the solves by multigrid
};

enum class solver_used { none, ldlt, multigrid };

/// Solves symmetric systems by ldlt or by multigrid. A SparseSolver; the default of all problems. Reads only the lower
/// triangle. For one question ldlt answers below 10,000 unknowns, for many below 200,000; where rows are long, as in
/// volumes, below 1,000 and 5,000. Rows are long if the whole matrix has more than 13 entries in a row, on average.
/// Else multigrid answers, and if it has not converged after 40 iterations, ldlt does, for all matrices of that
/// pattern. The rule depends on the matrix, the options and the solves so far, not on measured times: results are
/// reproducible. It takes at most about four times as long as the better of both. A factor has at most
/// max_factor_entries. They are counted before it is computed. Where it may be computed, multigrid never fails: a
/// matrix that is not positive definite, or a solve that misses the tolerance, goes to ldlt. Then errors are those of
/// ldlt. Where not, multigrid goes on. Give it a name to learn what it did: auto_solver s; harmonic_map(m, values, {},
/// s). Then s.used() names the method for the next solve, and s.has_replaced_multigrid() says whether ldlt took the
/// place of multigrid. s.iterations(), s.error(), s.residual() and s.has_converged() describe the last solve by
/// multigrid; for ldlt they are 0, 0, 0 and true. By multigrid, values far smaller than the largest have no correct
/// digits. A matrix with the pattern of the previous one reuses its order. Several threads may solve at once. Those
/// that multigrid answers take turns.
/// Errors: as ldlt and as multigrid; their messages begin with their names. invalid_argument if an option is out of its
///         range.
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
  /// Whether ldlt answers because multigrid has missed the tolerance, with this matrix or one of the same pattern
  /// before.
  bool has_replaced_multigrid() const;
  int iterations() const;
  double error() const;
  double residual() const;
  bool has_converged() const;
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/solve/detail/iterative/auto_solver.ipp>
#endif
