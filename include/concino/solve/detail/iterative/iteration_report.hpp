// What an iterative solver reports about its last solve.
#pragma once

#include <cstdint>

namespace concino::detail {

/// What an iterative solver knows about its last solve; see conjugate_gradients.
struct iteration_report {
  std::int64_t iterations = 0;
  double residual = 0, error = 0;
  bool has_converged = true;
};

}  // namespace concino::detail
