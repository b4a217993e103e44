// The smallest eigenpairs of symmetric sparse matrices that are too large for a factorisation.
// Not part of <concino/solve.hpp>: in header-only use it takes seconds to compile, for Eigen's dense eigenvalue solver.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/eigenproblem.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>

#include <Eigen/SparseCore>

#include <cstddef>

namespace concino {

/// The method that eigenpairs(k, m, count, lobpcg) and eigenfunctions(m, count, lobpcg) name: locally optimal block
/// preconditioned conjugate gradients. Calls without a method need <concino/adapters/spectra.hpp>.
struct lobpcg_method {};
inline constexpr lobpcg_method lobpcg{};

struct lobpcg_options {
  /// Of residuals, relative to the eigenvalue plus the shift, or rounding errors of K u if larger; above 0 and below 1.
  /// Errors of eigenvalues decrease with its square, and errors of vectors with the tolerance divided by the gap to the
  /// next eigenvalue.
  double tolerance = 1e-8;
  int max_iterations = 1000;  // 1 or more
  /// The preconditioner is a cycle for K + shift M; in units of the eigenvalues, finite, 0 or more. 0: the harmonic
  /// mean of K_ii / M_ii, divided by the number of rows, which is less than the first eigenvalues of Laplacians other
  /// than 0.
  double shift = 0;
  bool accept_missed_tolerance = false;   // true: returns the best pairs so far; has_converged says whether all meet
                                          // the tolerance
  concino::progress progress = nullptr;  // called with "eigenpairs"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

/// The smallest eigenvalues lambda of K u = lambda M u, and their vectors, by LOBPCG with a cycle of multigrid as
/// preconditioner. Nothing is factorised, so time and memory are proportional to the entries.
/// Needs:  K symmetric and positive semidefinite, such as minus a Laplacian; M symmetric and positive definite, lumped
///         or not; of both only the lower triangle is read. Rows that are empty in both are left out and counted.
///         count: at least 1, at most the number of remaining rows.
/// Result: `count` pairs, multiple eigenvalues repeated, with verified residuals; the same for any number of threads.
///         Eigenvalues that are zero are zero up to rounding. Multiplying K and M by powers of 2 scales values exactly,
///         and also vectors if that of M is a power of 4.
/// Cost:   on meshes of good shape some 10 to 20 iterations; in each, a cycle and two products with K for every vector
///         that has not converged, and O(rows count^2). O(entries + rows count) memory: four times the vectors and
///         their reserve of about one fifth, besides the matrices of multigrid. If rows are fewer than 256 or five
///         times the vectors, all pairs at once in O(rows^3).
/// Errors: invalid_argument if count or an option is out of its range, or the matrices differ in size. solver_error if
///         a matrix is not square, has entries that are not finite, a row has no mass, or M is found not to be positive
///         definite, or K to have an eigenvalue below minus the shift. solver_error if the tolerance is missed after
///         max_iterations, or because the iteration stagnates, unless accept_missed_tolerance. cancelled, by progress.
/// Source: Knyazev 2001, "Toward the optimal preconditioned eigensolver: locally optimal block preconditioned conjugate
///         gradient method"; basis as in Hetmaniuk, Lehoucq 2006, "Basis selection in LOBPCG", and Duersch, Shao, Yang,
///         Gu 2018, "A robust and efficient implementation of LOBPCG".
eigenpairs_result eigenpairs(const Eigen::SparseMatrix<double>& k, const Eigen::SparseMatrix<double>& m,
                             std::size_t count, lobpcg_method, const lobpcg_options& options = {});

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/solve/detail/eigen/eigenpairs.ipp>
#endif
