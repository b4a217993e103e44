// An iterative solver for symmetric positive definite sparse systems, in time proportional to the size of the mesh.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/solve/detail/iterative_system.hpp>
#include <concino/solve/detail/multigrid_levels.hpp>
#include <concino/solve/multigrid_options.hpp>

#include <Eigen/SparseCore>

namespace concino {

/// Solves symmetric positive definite systems by conjugate gradients, with a cycle of algebraic multigrid as preconditioner. A SparseSolver. For Laplacians
/// and similar matrices, the number of iterations hardly depends on the number of unknowns, so time and memory are proportional to the entries of the matrix.
/// Positive entries off the diagonal are allowed. Reads only the lower triangle of the matrix. Scaling the matrix or the right-hand side by a power of two
/// scales the solution exactly. `factorize` builds levels(), ever coarser matrices down to at most 256 unknowns, which a factorisation solves; a
/// matrix with the pattern of the previous one reuses its order. The result does not depend on the number of threads.
/// A solution is accepted as by conjugate_gradients: if error() and residual(), defined there, are at most the tolerance. iterations(), error(),
/// residual() and has_converged() describe the last solve. So one object must not solve in several threads at once.
/// With several right-hand sides on meshes of up to some 100,000 unknowns, ldlt is faster. On large meshes, and in volumes, multigrid is. Its interpolation
/// reproduces constants only. So it needs more iterations where linear functions have far less energy than the rest, as on flat polygons.
/// Errors: as conjugate_gradients; messages begin with multigrid.
/// Source: Vanek, Mandel, Brezina 1996, "Algebraic multigrid by smoothed aggregation for second and fourth order elliptic problems".
class multigrid {
  multigrid_options options_;
  detail::iterative_system system_;
  detail::multigrid_levels levels_;
  mutable detail::iteration_report report_;

 public:
  multigrid() = default;
  explicit multigrid(const multigrid_options& options);

  void factorize(const Eigen::SparseMatrix<double>& matrix);

  /// Whether this matrix has the pattern of the previous one, so that its order can be reused.
  bool has_pattern_of(const Eigen::SparseMatrix<double>& a) const { return system_.has_pattern_of(a); }

  Eigen::VectorXd solve(const Eigen::VectorXd& rhs) const;

  const multigrid_options& options() const { return options_; }
  static constexpr bool is_iterative() { return true; }
  /// The number of matrices, the given one included; 0 before the first factorize.
  int levels() const { return static_cast<int>(levels_.size()); }
  int iterations() const { return static_cast<int>(report_.iterations); }
  double error() const { return report_.error; }
  double residual() const { return report_.residual; }
  bool has_converged() const { return report_.has_converged; }
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/solve/detail/multigrid.ipp>
#endif
