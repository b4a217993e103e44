// Generalised eigenproblems K u = lambda M u of symmetric sparse matrices: checks, scaling, residuals and small dense
// problems, shared by all methods.
#pragma once

#include <concino/core/compiled.hpp>

#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace concino {

struct eigenpairs_result {
  Eigen::VectorXd values;       // smallest first
  Eigen::MatrixXd vectors;      // one per column, orthonormal with respect to the mass; the entry with the largest
                                // absolute value is positive
  Eigen::VectorXd residuals;    // |K u - lambda M u| / |M u|, in units of the eigenvalues
  std::size_t solves = 0;       // with K + shift M; of lobpcg cycles of multigrid, each for one vector
  std::size_t isolated = 0;     // rows without entries, where vectors are 0
  std::size_t iterations = 0;   // of lobpcg; 0 if a dense solver found all pairs at once
  bool has_converged = true;    // whether all residuals meet the tolerance
};

namespace core {

/// y = a x for a symmetric matrix given by its lower triangle.
Eigen::VectorXd symmetric_product(const Eigen::SparseMatrix<double>& lower, const Eigen::VectorXd& x);

/// Eigenvectors in columns that are orthonormal with respect to the mass, smallest eigenvalue first.
struct eigenbasis {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
  std::size_t solves = 0;
};

/// The eigenpairs within the span of the columns of v, as many as there are (Rayleigh-Ritz).
/// Errors: solver_error if the mass is not positive definite.
eigenbasis eigenpairs_within(const Eigen::SparseMatrix<double>& stiffness, const Eigen::SparseMatrix<double>& mass,
                             Eigen::MatrixXd v);

/// |K u - lambda M u| / |M u|, and an estimate of the rounding errors of the products in it.
struct eigen_residual {
  double size, rounding;

  eigen_residual(const Eigen::SparseMatrix<double>& stiffness, const Eigen::SparseMatrix<double>& mass, double value,
                 const Eigen::VectorXd& u);
};

[[noreturn, gnu::cold]] void throw_bad_eigenpair_count(std::size_t count, std::size_t rows);

/// K and M without the rows that are empty in both, scaled by powers of 2 so that the means of their diagonals are in
/// [1, 2); lower triangles.
struct eigenproblem {
  Eigen::SparseMatrix<double> stiffness, mass;
  std::vector<int> row;  // row numbers in the input matrices
  int stiffness_exponent = 0, mass_exponent = 0;
  double mean_stiffness = 0, mean_mass = 0;  // of the absolute values of the diagonals, scaled

  /// Errors: invalid_argument if the matrices differ in size. solver_error if they are not square, an entry is not
  ///         finite, or a row has no mass.
  eigenproblem(const Eigen::SparseMatrix<double>& k, const Eigen::SparseMatrix<double>& m);

  /// A value in units of the eigenvalues of the input, in those of the scaled problem.
  double scaled(double value) const;

  /// The pairs in the units of the input. of_row: the position of each row of this problem in the vectors found; empty:
  /// the same.
  eigenpairs_result result(const eigenbasis& found, const Eigen::VectorXd& residuals, Eigen::Index rows,
                           const std::vector<int>& of_row = {}) const;

 private:
  std::vector<int> number_rows(const Eigen::SparseMatrix<double>& k, const Eigen::SparseMatrix<double>& m);
  void choose_scales(const std::vector<double>& k_diagonal, const std::vector<double>& m_diagonal);
  Eigen::SparseMatrix<double> part(const Eigen::SparseMatrix<double>& a, const std::vector<int>& new_row,
                                   int exponent) const;
};

/// The residuals of all pairs, each checked with its vector.
Eigen::VectorXd eigen_residuals(const eigenproblem& problem, const eigenbasis& found);

/// All pairs at once by a dense solver, in O(rows^3), of which the first `count` are kept.
eigenbasis dense_eigenpairs(const eigenproblem& problem, std::size_t count);

}  // namespace core

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/core/detail/eigenproblem.ipp>
#endif
