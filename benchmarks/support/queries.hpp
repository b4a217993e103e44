// Query points for trees: the same random points for every contender.
#pragma once

#include <concino/geometry/bounding_tree.hpp>

#include <cstddef>
#include <random>
#include <vector>

namespace bench {

/// n random points in the bounding box of m, enlarged by `margin` times its size on every side.
template<class M>
std::vector<concino::vec3> places_near(const M& m, std::size_t n, double margin) {
  const concino::box b = concino::bounding_box(m);
  std::mt19937 random(11);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0 * (1 + 2 * margin) - margin; };
  std::vector<concino::vec3> places(n);
  for (auto& x : places)
    for (std::size_t k = 0; k < 3; ++k) x[k] = b.min[k] + uniform() * (b.max[k] - b.min[k]);
  return places;
}

inline double sum_of_distances(const auto& tree, const std::vector<concino::vec3>& places) {
  double sum = 0;
  for (const auto& x : places) sum += tree.closest(x).distance;
  return sum;
}

/// The number of rays, from each place to the next one, that hit a poly.
inline std::size_t rays_that_hit(const auto& tree, const std::vector<concino::vec3>& places) {
  std::size_t hits = 0;
  for (std::size_t i = 1; i < places.size(); ++i) hits += static_cast<bool>(tree.ray(places[i - 1], places[i] - places[i - 1]));
  return hits;
}

}  // namespace bench
