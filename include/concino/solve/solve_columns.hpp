// Solves for many right-hand sides with one factorisation.
#pragma once

#include <concino/concepts/sparse_solver.hpp>

#include <Eigen/SparseCore>

namespace concino {

/// Solves with a factorised matrix for every column of b.
/// Needs:  a SparseSolver that has factorised.
/// Result: the solutions, column by column; each is the result of solver.solve for that column.
/// Cost:   as many solves as columns; nothing is factorised.
/// Errors: as solver.solve.
template<class Solver>
  requires SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
Eigen::MatrixXd solve_columns(const Solver& solver, const Eigen::MatrixXd& b) {
  Eigen::MatrixXd x;
  for (Eigen::Index c = 0; c < b.cols(); ++c) {
    const Eigen::VectorXd column = b.col(c), solution = solver.solve(column);
    if (c == 0) x.resize(solution.size(), b.cols());
    x.col(c) = solution;
  }
  return x;
}

}  // namespace concino
