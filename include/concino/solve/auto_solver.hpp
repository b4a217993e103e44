// The solver for whoever does not want to choose one: a factorisation where its memory allows, and else an iteration.
#pragma once

#include <concino/solve/conjugate_gradients.hpp>
#include <concino/solve/ldlt.hpp>

#include <cstdint>

namespace concino {

struct auto_solver_options {
  std::int64_t most_factor_entries = 100'000'000;  // below the diagonal; 12 bytes each; at least 0
  conjugate_gradients_options iteration = {};      // used where the factor would have more entries
};

enum class solver_used { none, ldlt, conjugate_gradients };

/// Solves symmetric systems: by ldlt if its factor, whose entries are counted before anything is factorised, has at most most_factor_entries, and
/// else, for positive definite matrices only, by conjugate_gradients. A SparseSolver; the default of all problems. Only the lower triangle is read.
/// It says what it did if it is given a name: auto_solver s; harmonic_map(m, values, {}, s); then s.used(), and s.iterations(), s.error(), s.residual() and
/// s.converged() of the last solve by conjugate_gradients, which are 0, 0, 0 and true for ldlt. Either way gives the same values up to 1e-9 of the
/// largest on grids of triangles, tets and hexes graded by x^3; by iteration, values far smaller than the largest have no correct digits.
/// The limit is reached by Laplacians of triangle surfaces of about 3 million verts, and of grids of hexes of about 50 verts a side. A matrix
/// with the pattern of the one factorised before is factorised in the order found then.
/// Errors: as ldlt and as conjugate_gradients; their messages begin with their names. invalid_argument if an option is out of its range.
class auto_solver {
  auto_solver_options options_;
  ldlt direct_;
  conjugate_gradients iteration_;
  solver_used used_ = solver_used::none;

 public:
  auto_solver() = default;
  explicit auto_solver(const auto_solver_options& options) : options_(options), iteration_(options.iteration) {
    if (options.most_factor_entries < 0) throw invalid_argument("auto_solver: most_factor_entries is negative");
  }

  void factorize(const Eigen::SparseMatrix<double>& a) {
    used_ = solver_used::none;
    if (!iteration_.has_pattern_of(a) && direct_.factorize_within(a, options_.most_factor_entries)) {
      used_ = solver_used::ldlt;
    } else {
      iteration_.factorize(a);
      used_ = solver_used::conjugate_gradients;
    }
  }

  /// Takes over the order that another has found for a factorisation, see ldlt.
  void use_order_of(const auto_solver& other) {
    used_ = solver_used::none;
    direct_.use_order_of(other.direct_);
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const {
    if (used_ == solver_used::none) throw solver_error("auto_solver: solve without a factorised matrix; call factorize first");
    return used_ == solver_used::ldlt ? direct_.solve(b) : iteration_.solve(b);
  }

  const auto_solver_options& options() const { return options_; }
  /// What the last factorize chose; none before it, and after one that failed.
  solver_used used() const { return used_; }
  bool iterates() const { return used_ == solver_used::conjugate_gradients; }
  int iterations() const { return iterates() ? iteration_.iterations() : 0; }
  double error() const { return iterates() ? iteration_.error() : 0; }
  double residual() const { return iterates() ? iteration_.residual() : 0; }
  bool converged() const { return !iterates() || iteration_.converged(); }
};

}  // namespace concino
