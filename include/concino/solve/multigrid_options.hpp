// The options of multigrid.
#pragma once

namespace concino {

struct multigrid_options {
  double tolerance = 1e-12;              // of the estimated error and of the residual, see multigrid; in (0, 1)
  int max_iterations = 0;                // 0: twice the number of unknowns
  bool accept_missed_tolerance = false;  // true: solve returns the best result so far; has_converged() says whether it
                                         // meets the tolerance
};

}  // namespace concino
