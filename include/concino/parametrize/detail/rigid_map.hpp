// Maps of disks to the plane that are as rigid as possible, from flat arrays.
#pragma once

#include <concino/parametrize/detail/plane_maps.hpp>

#include <vector>

namespace concino::detail {

struct iteration_limits {
  int max_iterations;
  double tolerance;
  const progress& on_progress;
};
struct iterated_map {
  plane_points uv;
  std::vector<double> energies;
  bool has_converged = false;
};

/// Errors: invalid_argument if a limit is out of its range.
void check_limits(const iteration_limits& limits, const char* caller);

/// See arap_map.
iterated_map local_global_map(const flat_disk& f, const fixed_points& fixed, const iteration_limits& limits);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/parametrize/detail/rigid_map.ipp>
#endif
