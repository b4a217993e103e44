// Eigenpairs of large sparse matrices, and Laplacian eigenfunctions of surfaces and volumes of any polys, by Spectra.
// Needs: Spectra (Debian: libspectra-dev).
#pragma once

#include <concino/adapters/detail/spectra_lanczos.hpp>
#include <concino/concepts/sparse_solver.hpp>
#include <concino/core/eigenproblem.hpp>
#include <concino/core/residual.hpp>
#include <concino/fields/eigenfunctions_result.hpp>
#include <concino/operators/laplacian.hpp>
#include <concino/operators/mass_matrix.hpp>
#include <concino/solve/ldlt.hpp>

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace concino {

struct eigenpairs_options {
  double tolerance = 1e-10;  // of residuals, relative to the eigenvalue plus the shift, or rounding errors of K u if
                             // larger; above 0 and below 1
  int max_restarts = 1000;   // of the iteration, 1 or more
  /// K + shift M is factorised; in units of the eigenvalues, finite, 0 or more. 0: the mean of the diagonal of K,
  /// divided by that of M and by the number of rows.
  double shift = 0;
};

namespace detail {

inline void check_eigenpairs_options(const eigenpairs_options& options) {
  if (!(options.tolerance > 0 && options.tolerance < 1))
    core::throw_joined<invalid_argument>(
        {"eigenpairs: tolerance is ", core::number_text(options.tolerance), "; it must be above 0 and below 1"});
  if (options.max_restarts <= 0) throw invalid_argument("eigenpairs: max_restarts must be 1 or more");
  if (!(options.shift >= 0 && std::isfinite(options.shift)))
    core::throw_joined<invalid_argument>(
        {"eigenpairs: shift is ", core::number_text(options.shift), "; it must be finite and 0 or more"});
}

}  // namespace detail

/// The smallest eigenvalues lambda of K u = lambda M u, and their vectors.
/// Needs:  K symmetric and positive semidefinite, such as minus a Laplacian; M symmetric and positive definite, lumped
///         or not; of both only the lower triangle is read. Rows that are empty in both are left out and counted.
///         count: at least 1, at most the number of remaining rows. solver: a SparseSolver for K + shift M, which is
///         positive definite.
/// Result: `count` pairs, multiple eigenvalues repeated, with verified residuals; deterministic. Eigenvalues that are
///         zero are zero up to rounding. Multiplying K and M by powers of 2 scales values exactly, and also vectors if
///         that of M is a power of 4.
/// Cost:   one factorisation and, for each pair, some 3 to 11 solves; O(rows count) memory. If rows < 2 count + 1 or
///         there are no more than 32 rows, all at once in O(rows^3).
/// Errors: invalid_argument if count or an option is out of its range, or the matrices differ in size. solver_error if
///         a matrix has entries that are not finite, a row has no mass, or M is not positive definite. solver_error if
///         not all pairs have converged: it names how many have, and the residual. Those of the solver.
/// Source: Lehoucq, Sorensen 1996, "Deflation techniques for an implicitly restarted Arnoldi iteration", in Spectra;
///         paper section 2.2.
template<class Solver = ldlt>
  requires SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd> eigenpairs_result
  eigenpairs(const Eigen::SparseMatrix<double>& k, const Eigen::SparseMatrix<double>& m, std::size_t count,
             const eigenpairs_options& options = {}, Solver&& solver = {}) {
    detail::check_eigenpairs_options(options);
    const core::eigenproblem problem(k, m);
    const std::size_t rows = problem.row.size();
    if (count < 1 || count > rows) core::throw_bad_eigenpair_count(count, rows);
    core::eigenbasis found;
    if (rows <= 32 || rows < 2 * count + 1) {
      found = core::dense_eigenpairs(problem, count);
    } else {
      double shift = 1;
      if (options.shift > 0) shift = problem.scaled(options.shift);
      else if (problem.mean_stiffness > 0)
        shift = problem.mean_stiffness / problem.mean_mass / static_cast<double>(rows);
      const Eigen::SparseMatrix<double> shifted = problem.stiffness + shift * problem.mass;
      core::factorize_symmetric(solver, shifted);
      const auto solve = [&](const Eigen::VectorXd& b) -> Eigen::VectorXd { return std::as_const(solver).solve(b); };
      found = detail::smallest_eigenpairs(problem.stiffness, problem.mass, solve, shift,
                                          static_cast<Eigen::Index>(count), options.tolerance, options.max_restarts);
    }
    return problem.result(found, core::eigen_residuals(problem, found), k.rows());
  }

struct eigenfunctions_options {
  bool lumped = true;        // mass matrix, see mass_matrix: if it is not lumped, values converge from above
  double tolerance = 1e-10;  // as that of eigenpairs
  int max_restarts = 1000;   // as that of eigenpairs
};

/// The Laplacian eigenfunctions of a surface or a volume, with Neumann boundary conditions: minus the Laplacian of each
/// is its value times the function, and its normal derivative at the boundary is zero. The Laplacian is that of the
/// discretisation argument, after the count, or that of virtual_elements.
/// Needs:  EmbeddedMesh M, no temporary; with a Discretisation also what that needs. count: at least 1, at most the
///         verts of polys. solver: as for eigenpairs.
/// Result: `count` functions; the first is constant with value 0, and the value 0 occurs once per component of polys.
///         Errors of values decrease with the square of the edge length. Scaling the mesh by a power of 2 scales values
///         exactly, and also functions, but those of volumes only for a power of 4.
/// Cost:   as laplacian, mass_matrix and eigenpairs.
/// Errors: as laplacian, mass_matrix and eigenpairs.
/// Source: Vallet, Levy 2008, "Spectral geometry processing with manifold harmonics"; Reuter, Wolter, Peinecke 2006,
///         "Laplace-Beltrami spectra as Shape-DNA"; Kac 1966, "Can one hear the shape of a drum?".
template<class M, class Solver = ldlt>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M> &&
      SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          eigenfunctions_result<std::remove_cvref_t<M>> eigenfunctions(M&& m, std::size_t count,
                                                                       const eigenfunctions_options& options = {},
                                                                       Solver&& solver = {}) {
    return eigenfunctions(m, count, virtual_elements, options, solver);
  }
template<class M, class D, class Solver = ldlt>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M> && Discretisation<D, M> &&
      SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          eigenfunctions_result<std::remove_cvref_t<M>> eigenfunctions(M&& m, std::size_t count,
                                                                       const D& discretisation,
                                                                       const eigenfunctions_options& options = {},
                                                                       Solver&& solver = {}) {
    const Eigen::SparseMatrix<double> k = -laplacian(m, discretisation);
    const eigenpairs_result pairs =
        eigenpairs(k, mass_matrix(m, {.lumped = options.lumped}), count,
                   {.tolerance = options.tolerance, .max_restarts = options.max_restarts}, solver);
    return core::eigenfunctions_from(m, pairs);
  }

}  // namespace concino
