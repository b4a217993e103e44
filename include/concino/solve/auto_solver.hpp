// The solver for whoever does not want to choose one: a factorisation where its memory allows, and else an iteration.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/solve/conjugate_gradients_options.hpp>

#include <Eigen/SparseCore>

#include <cstdint>
#include <memory>

namespace concino {

struct auto_solver_options {
  std::int64_t max_factor_entries = 100'000'000;  // below the diagonal; 12 bytes each; at least 0
  conjugate_gradients_options iteration = {};      // used where the factor would have more entries
};

enum class solver_used { none, ldlt, conjugate_gradients };

/// Solves symmetric systems: by ldlt if its factor, whose entries are counted before anything is factorised, has at most max_factor_entries, and
/// else, for positive definite matrices only, by conjugate_gradients. A SparseSolver; the default of all problems. Only the lower triangle is read.
/// It says what it did if it is given a name: auto_solver s; harmonic_map(m, values, {}, s); then s.used(), and s.iterations(), s.error(), s.residual() and
/// s.has_converged() of the last solve by conjugate_gradients, which are 0, 0, 0 and true for ldlt. Either way gives the same values up to 1e-9 of the
/// largest on grids of triangles, tets and hexes graded by x^3; by iteration, values far smaller than the largest have no correct digits.
/// The limit is reached by Laplacians of triangle surfaces of about 3 million verts, and of grids of hexes of about 50 verts a side. A matrix
/// with the pattern of the one factorised before is factorised in the order found then.
/// Errors: as ldlt and as conjugate_gradients; their messages begin with their names. invalid_argument if an option is out of its range.
class auto_solver {
  struct solvers;  // ldlt and conjugate_gradients, which are long to compile
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

  /// Takes over the order that another has found for a factorisation, see ldlt.
  void use_order_of(const auto_solver& other);

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

  const auto_solver_options& options() const { return options_; }
  /// What the last factorize chose; none before it, and after one that failed.
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
