// What conjugate_gradients can be asked for.
#pragma once

namespace concino {

struct conjugate_gradients_options {
  double tolerance = 1e-12;             // of the estimated error and of the residual, see below; in (0, 1)
  int max_iterations = 0;               // 0: twice as many as there are unknowns
  bool accept_missed_tolerance = false; // true: solve returns the best it has reached; has_converged() says whether that meets the tolerance
};

}  // namespace concino
