// Options and results of quadratic programs.
#pragma once

#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>

#include <Eigen/Core>

namespace concino {

struct qp_options {
  double tolerance = 1e-6;                // of the residual, relative to its terms; 1e-12 to 1
  int max_iterations = 20000;             // of the splitting, 1 or more
  bool polish = true;                     // solve once more for the active bounds, which reduces the residual to
                                          // rounding errors
  Eigen::VectorXd x = {}, multipliers = {};  // the start, such as the solution of a similar program; empty: 0
  concino::progress progress = nullptr;   // called occasionally
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

enum class qp_status { solved, infeasible, unbounded, not_converged };

struct qp_result {
  qp_status status = qp_status::not_converged;
  Eigen::VectorXd x;            // the minimiser; if there is none, the last iterate
  Eigen::VectorXd multipliers;  // one per row of A: negative if the lower bound is active, positive if the upper one is
  double residual = 0;          // the largest of |Hx + g + A^T multipliers| and of the violations of the bounds by Ax
  int iterations = 0;
  bool polished = false;
  Eigen::VectorXd certificate;  // infeasible: y with A^T y = 0 and contradicting bounds; unbounded: a direction in
                                // which the objective decreases
};

}  // namespace concino
