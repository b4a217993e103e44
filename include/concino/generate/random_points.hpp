// Random points in a box, for the sites of Voronoi meshes and for tests.
#pragma once

#include <concino/core/error.hpp>
#include <concino/generate/detail/common/random.hpp>
#include <concino/geometry/bounding_box.hpp>

#include <vector>

namespace concino {

/// n points in a box, independent and uniformly distributed.
/// Needs:  a finite box that is not empty; it may be flat.
/// Result: the same points for the same seed, to the last bit, on every machine. The first n of a longer list are the
///         list of n.
/// Cost:   O(n).      Errors: invalid_argument if the box is empty or not finite.
/// Source: SplitMix64, Steele, Lea and Flood 2014.
inline std::vector<vec3> random_points(std::size_t n, const box& domain, std::uint64_t seed = 1) {
  if (domain.is_empty() || !is_finite(domain.max - domain.min))
    throw invalid_argument("random_points: the box must not be empty, and its corners and size must be finite");
  detail::random_stream random(seed);
  std::vector<vec3> points(n);
  for (vec3& x : points)
    for (std::size_t k = 0; k < 3; ++k) x[k] = random.between(domain.min[k], domain.max[k]);
  return points;
}

}  // namespace concino
