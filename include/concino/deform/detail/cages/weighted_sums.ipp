// Bodies of weighted_sums.hpp: points of meshes and lists by their index, and sums of weights times such points.
#pragma once

#include <concino/core/parallel.hpp>
#include <concino/deform/detail/cages/weighted_sums.hpp>

namespace concino::detail {

CONCINO_INLINE void throw_point_not_finite(const char* caller, const char* what, std::size_t index) {
  const auto text = core::joined({caller, ": ", what, " ", index, " has a coordinate that is not finite"});
  if (what[0] == 'v') throw invalid_mesh(text);
  throw invalid_argument(text);
}

CONCINO_INLINE void check_bent_cage(std::size_t found, std::size_t expected) {
  if (found != expected)
    core::throw_joined<invalid_argument>({"points_of: the bent cage has ", found, " verts, and the cage had ", expected,
                                          "; pass a copy of the cage whose points were moved"});
}

CONCINO_INLINE std::vector<vec3> weighted_sums(const std::vector<double>& weights, std::size_t row_size, std::size_t n,
                                               const std::vector<vec3>& points) {
  check_bent_cage(points.size(), row_size);
  std::vector<vec3> sums(n);
  parallel_for(
      n,
      [&](std::size_t i) {
        const double* const w = weights.data() + i * row_size;
        vec3 sum;
        for (std::size_t k = 0; k < row_size; ++k) sum += w[k] * points[k];
        sums[i] = sum;
      },
      64);
  return sums;
}

}  // namespace concino::detail
