// The default solver: a factorisation if its memory allows, otherwise an iteration.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/solve/conjugate_gradients_options.hpp>

#include <Eigen/SparseCore>

#include <cstdint>
#include <memory>

namespace concino {

struct auto_solver_options {
  std::int64_t max_factor_entries = 100'000'000;  // below the diagonal, 12 bytes each; at least 0
  conjugate_gradients_options iteration = {};      // used if the factor would have more entries
};

enum class solver_used { none, ldlt, conjugate_gradients };

/// Solves symmetric systems with ldlt if its factor has at most max_factor_entries, which are counted before the factorisation. Otherwise with
/// conjugate_gradients, for positive definite matrices only. A SparseSolver; the default of all problems. Reads only the lower triangle.
/// Give it a name to learn what it did: auto_solver s; harmonic_map(m, values, {}, s). Then s.used() names the method. s.iterations(), s.error(),
/// s.residual() and s.has_converged() describe the last solve by conjugate_gradients; for ldlt they are 0, 0, 0 and true. Both methods agree up to 1e-9 of
/// the largest value on grids of triangles, tets and hexes graded by x^3. By iteration, values far smaller than the largest have no correct digits.
/// The limit is reached by Laplacians of triangle surfaces of about 3 million verts, and of grids of hexes of about 50 verts per axis. A matrix
/// with the pattern of the previously factorised one reuses its order.
/// Errors: as ldlt and as conjugate_gradients; their messages begin with their names. invalid_argument if an option is out of its range.
class auto_solver {
  struct solvers;  // ldlt and conjugate_gradients, which take long to compile
  auto_solver_options options_;
  std::unique_ptr<solvers> solvers_;
  solver_used used_ = solver_used::none;

 public:
  auto_solver();
  explicit auto_solver(const auto_solver_options& options);
  auto_solver(const auto_solver&) = delete;
  auto_solver& operator=(const auto_solver&) = delete;
  ~auto_solver();

  void factorize(const Eigen::SparseMatrix<double>& a);

  /// Copies the elimination order of another solver, see ldlt.
  void use_order_of(const auto_solver& other);

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

  const auto_solver_options& options() const { return options_; }
  /// The method that the last factorize chose; none before the first, and after one that failed.
  solver_used used() const { return used_; }
  bool is_iterative() const { return used_ == solver_used::conjugate_gradients; }
  int iterations() const;
  double error() const;
  double residual() const;
  bool has_converged() const;
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/solve/detail/auto_solver.ipp>
#endif
