// An iterative solver for symmetric positive definite sparse systems, in time proportional to the size of the mesh.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/solve/detail/iterative/iterative_system.hpp>
#include <concino/solve/detail/multigrid/multigrid_levels.hpp>
#include <concino/solve/multigrid_options.hpp>

#include <Eigen/SparseCore>

namespace concino {

/// Solves symmetric positive definite systems by conjugate gradients, with a cycle of algebraic multigrid as
/// preconditioner. A SparseSolver. For Laplacians and similar matrices, the number of iterations hardly depends on the
/// number of unknowns, so time and memory are proportional to the entries of the matrix. Positive entries off the
/// diagonal are allowed. Reads only the lower triangle of the matrix. Scaling the matrix or the right-hand side by a
/// power of two scales the solution exactly. `factorize` builds levels(), ever coarser matrices down to at most 256
/// unknowns, which a factorisation solves; a matrix with the pattern of the previous one reuses its order. The result
/// does not depend on the number of threads. A solution is accepted as by conjugate_gradients: if error() and
/// residual(), defined there, are at most the tolerance. iterations(), error(), residual() and has_converged() describe
/// the last solve. So one object must not solve in several threads at once. Iterations to a tolerance of 1e-10 for
/// Poisson's equation with 10^4 and 10^6 unknowns, and values given on the boundary:
/// - uniform meshes: triangles 14 and 14, quads 15 and 15, Voronoi polygons 17 and 24, tets 13 and 14, hexes 14 and 15;
/// - graded by x^3: triangles, quads and tets 14 to 15 and 14 to 16, hexes 13 and 24, Voronoi polygons 28 and 60;
/// - cells stretched 1 : 100: triangles, quads, tets and hexes 13 to 16 and 14 to 17, Voronoi polygons 27 and 66.
/// Voronoi polyhedra take 13 to 18 with up to 10^5 unknowns.
/// The worst case are flat cells other than triangles and tets, if no values are given along their large faces. Hexes
/// graded by x^3, with values on two sides only, take 86 iterations at 10^4, 194 at 10^5 and 434 at 10^6 unknowns. The
/// stabilisation of virtual elements then dominates, and its kernel is larger than the constants that the interpolation
/// reproduces. Trilinear elements on the same grids take 18. Memory held after factorize: 0.8 to 1.5 times that of the
/// whole symmetric matrix; at most 5 times while it runs.
/// Errors: as conjugate_gradients; messages begin with multigrid.
/// Source: Vanek, Mandel, Brezina 1996, "Algebraic multigrid by smoothed aggregation for second and fourth order
///         elliptic problems".
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
#include <concino/solve/detail/multigrid/multigrid.ipp>
#endif
