#include "call.hpp"

#include <concino/optimize.hpp>

void call_optimize() {
  Eigen::SparseMatrix<double> i(2, 2), row(1, 2);
  i.setIdentity();
  row.insert(0, 0) = 1;
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(2), d = Eigen::VectorXd::Ones(1);
  call("solve_with_constraints", [&] { cn::solve_with_constraints(i, b, row, d); });
  call("least_squares", [&] { cn::least_squares(i, b); });
  call("weighted_least_squares", [&] { cn::weighted_least_squares(i, b, b); });
  call("solve_qp", [&] { cn::solve_qp(i, b, row, d, d); });
  call("solve_with_values", [&] { cn::solve_with_values(i, b, {{0, 1.0}}); });
}
