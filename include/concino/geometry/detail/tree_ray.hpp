// Ray queries of a tree.
#pragma once

#include <concino/core/error.hpp>
#include <concino/geometry/detail/box_tree.hpp>
#include <concino/geometry/detail/ray_test.hpp>
#include <concino/geometry/tree_hits.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace concino::detail {

/// A ray in the units of the tree. Its direction is scaled to a magnitude of about 1 by a power of two.
template<class Pieces>
class tree_ray {
  using crossing = ray_test::crossing;

  const Pieces& pieces_;
  const box_tree& boxes_;
  vec3 origin_;
  int shift_;   // a parameter here times 2^shift is one of the caller's
  double end_;
  ray_test test_;

  static int exponent_of(const vec3& direction) {
    int exponent = 0;
    std::frexp(std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)}), &exponent);
    return exponent;
  }
  static const vec3& checked(const vec3& origin, const vec3& direction, const ray_options& options) {
    if (!is_finite(origin)) core::throw_joined<invalid_argument>({"ray: the origin is not finite"});
    if (!is_finite(direction) || direction == vec3{})
      core::throw_joined<invalid_argument>({"ray: the direction is 0 or not finite"});
    if (!(options.max_parameter >= 0))
      core::throw_joined<invalid_argument>({"ray: max_parameter is negative or not a number"});
    return direction;
  }
  static vec3 near_one(const vec3& direction) {
    const int e = exponent_of(direction);
    return {std::ldexp(direction.x, -e), std::ldexp(direction.y, -e), std::ldexp(direction.z, -e)};
  }

  /// Calls visit(rank, crossing) for items near the ray.
  template<class Visit>
  void search(const double& limit, Visit&& visit) const {
    boxes_.search([&](const box_node& n) { return test_.enters(n.min, n.max); }, limit, [&](std::size_t i) {
      crossing first;
      if constexpr (Pieces::are_solid)
        if (pieces_.holds(i, origin_)) first = {0, origin_};
      pieces_.for_each_triangle(i, [&](const vec3& a, const vec3& b, const vec3& c) {
        if (const crossing found = test_(a, b, c); found.parameter < first.parameter) first = found;
      });
      if (first && first.parameter <= end_) visit(static_cast<std::size_t>(pieces_.owner(i)), first);
    });
  }

 public:
  tree_ray(const Pieces& pieces, const box_tree& boxes, const vec3& origin, const vec3& direction,
           const ray_options& options)
      : pieces_(pieces), boxes_(boxes), origin_(pieces.to_tree(origin)),
        shift_(pieces.exponent() - exponent_of(checked(origin, direction, options))),
        end_(std::ldexp(options.max_parameter, -shift_)), test_(origin_, near_one(direction)) {}

  /// The first poly that the ray hits, or no crossing.
  std::pair<std::size_t, crossing> first() const {
    std::pair<std::size_t, crossing> best{0, {}};
    double limit = end_;
    search(limit, [&](std::size_t rank, const crossing& c) {
      if (c.parameter > best.second.parameter || (c.parameter == best.second.parameter && rank >= best.first)) return;
      best = {rank, c};
      limit = c.parameter;
    });
    return best;
  }

  /// The first hit of every poly, sorted by parameter and then by rank.
  std::vector<std::pair<std::size_t, crossing>> all() const {
    std::vector<std::pair<std::size_t, crossing>> hits;
    search(end_, [&](std::size_t rank, const crossing& c) { hits.push_back({rank, c}); });
    std::sort(hits.begin(), hits.end(), [](const auto& a, const auto& b) {
      return a.first < b.first || (a.first == b.first && a.second.parameter < b.second.parameter);
    });
    const auto is_same_poly = [](const auto& a, const auto& b) { return a.first == b.first; };
    hits.erase(std::unique(hits.begin(), hits.end(), is_same_poly), hits.end());
    std::stable_sort(hits.begin(), hits.end(),
                     [](const auto& a, const auto& b) { return a.second.parameter < b.second.parameter; });
    return hits;
  }

  template<class M>
  crossing_hit<M> hit(std::size_t rank, const crossing& c) const {
    return {pieces_.poly(rank), pieces_.to_mesh(c.point), std::ldexp(c.parameter, shift_), true};
  }
};

}  // namespace concino::detail
