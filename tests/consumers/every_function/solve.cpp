#include "call.hpp"

#include <concino/solve.hpp>
#include <concino/solve/eigenpairs.hpp>
#include <concino/solve/solve_columns.hpp>

void call_solve() {
  Eigen::SparseMatrix<double> i(9, 9), k(9, 9);
  i.setIdentity();
  for (int n = 0; n < 9; ++n) k.insert(n, n) = n;
  call("eigenpairs", [&] { cn::eigenpairs(k, i, 1, cn::lobpcg); });
  call("solve_columns", [&] {
    cn::ldlt solver;
    solver.factorize(i);
    cn::solve_columns(solver, Eigen::MatrixXd::Ones(9, 2));
  });
}
