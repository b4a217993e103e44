// What a quadratic program is asked with, and what it answers.
#pragma once

#include <concino/core/progress.hpp>

#include <Eigen/Core>

namespace concino {

struct qp_options {
  double tolerance = 1e-6;                // of the residual, beside the terms it is the difference of; 1e-12 to 1
  int max_iterations = 20000;             // of the splitting, 1 or more
  bool polish = true;                     // solve once more for the bounds found active, which takes the residual to rounding errors
  Eigen::VectorXd x = {}, multipliers = {};  // where to start: of a solution of a similar program; empty: 0
  concino::progress progress = nullptr;   // told now and then
};

enum class qp_status { solved, infeasible, unbounded, not_converged };

struct qp_result {
  qp_status status = qp_status::not_converged;
  Eigen::VectorXd x;            // the minimiser; where there is none, the last step
  Eigen::VectorXd multipliers;  // one per row of A: negative where the lower bound holds x back, positive where the upper one does
  double residual = 0;          // the largest of |Hx + g + A^T multipliers| and of the amounts by which Ax leaves its bounds
  int iterations = 0;
  bool polished = false;
  Eigen::VectorXd certificate;  // infeasible: y with A^T y = 0 with contradicting bounds; unbounded: a direction in which the objective falls
};

}  // namespace concino
