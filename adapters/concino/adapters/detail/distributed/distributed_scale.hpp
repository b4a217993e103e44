// Distributed meshes scaled to a size near 1, as one process scales the whole mesh.
#pragma once

#include <concino/adapters/distributed.hpp>
#include <concino/fields/support/linear_problem_parts.hpp>

#include <mpi.h>

namespace concino::detail {

/// length_exponent of the whole mesh. Collective.
template<class M>
int common_length_exponent(const distributed<M>& m) {
  double largest = largest_finite_coordinate(m.base());
  (MPI_Allreduce)(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, m.communicator());
  return length_exponent(largest);
}

/// A mesh or view with all coordinates times 2^-exponent.
template<class M>
views::scaled<M> scaled_by(const M& m, int exponent) {
  return {m, exponent};
}

}  // namespace concino::detail
