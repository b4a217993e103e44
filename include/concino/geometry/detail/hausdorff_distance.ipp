// Defines hausdorff_distance.hpp. Each part of a triangle has an upper bound, see polygon_part. Only parts whose bound
// exceeds the largest distance met so far are cut into smaller ones.
#pragma once

#include <concino/core/parallel.hpp>
#include <concino/core/polygon_part.hpp>
#include <concino/geometry/hausdorff_distance.hpp>
#include <concino/geometry/support/triangle_tree.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace concino::detail {

class distance_search {
  const core::triangle_tree& to_;
  std::vector<core::polygon_part> parts_;  // a heap: those that may have a larger distance than `lower_`
  double lower_ = 0;
  double done_ = 0;  // the upper bound of the parts that were left out because they hardly exceed the lower one
  double enough_;    // bounds may differ by this factor

  bool matters(double upper) const {
    return upper > enough_ * lower_ && upper > core::polygon_part::unit * core::polygon_part::unit;
  }

  void add(const core::polygon_part& p) {
    if (!matters(p.upper)) {
      done_ = std::max(done_, p.upper);
      return;
    }
    parts_.push_back(p);
    std::push_heap(parts_.begin(), parts_.end());
  }
  void bound_and_add(core::polygon_part& p) {
    lower_ = std::max(lower_, p.bound(to_, p.candidate));
    add(p);
  }
  /// Splits a part at the edges of its candidate. If that splits nothing, the part is halved.
  void cut(core::polygon_part p) {
    const bool any =
        p.split_at(to_.triangle(p.candidate), [&](core::polygon_part& outside) { bound_and_add(outside); });
    if (any) return bound_and_add(p);
    auto halves = p.halves();
    if (halves[0].n < 3 || halves[1].n < 3) done_ = std::max(done_, p.upper);  // it is a point, up to rounding
    else for (core::polygon_part& half : halves) bound_and_add(half);
  }

 public:
  distance_search(const core::triangle_tree& to, double tolerance)
      : to_(to), enough_(1 / ((1 - tolerance) * (1 - tolerance))) {}

  void start(const std::vector<triangle_points>& from) {
    std::vector<core::polygon_part> all(from.size());
    std::vector<double> largest(from.size());
    parallel_for(from.size(), [&](std::size_t i) {
      for (const vec3& x : from[i]) all[i].add(x);
      largest[i] = all[i].bound(to_, 0);
      for (const vec3& x : from[i]) largest[i] = std::max(largest[i], to_.nearest(x, all[i].candidate).squared);
    }, 256);
    for (const double d : largest) lower_ = std::max(lower_, d);
    for (const core::polygon_part& p : all) add(p);
  }

  /// Squared bounds.
  distance_bounds run(double max_cuts) {
    for (double cuts = 0; cuts < max_cuts && !parts_.empty() && matters(parts_[0].upper); ++cuts) {
      std::pop_heap(parts_.begin(), parts_.end());
      const core::polygon_part p = parts_.back();
      parts_.pop_back();
      cut(p);
    }
    return {lower_, std::max({lower_, done_, parts_.empty() ? 0 : parts_[0].upper})};
  }
};

CONCINO_INLINE distance_bounds distance_between(std::vector<triangle_points> from, std::vector<triangle_points> to,
                                                const hausdorff_options& options, const char* caller) {
  if (!(options.tolerance >= 0 && options.tolerance < 1))
    core::throw_joined<invalid_argument>({caller, ": options.tolerance must be at least 0 and less than 1"});
  if (!(options.max_cuts >= 0))
    core::throw_joined<invalid_argument>(
        {caller, ": options.max_cuts is negative or not a number; it must be at least 0"});
  constexpr double infinite = std::numeric_limits<double>::infinity();
  if (from.empty()) return {};
  if (to.empty()) return {infinite, infinite};
  double largest = 0;
  for (const auto* triangles : {&from, &to})
    for (const triangle_points& t : *triangles)
      for (const vec3& x : t) largest = std::max({largest, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
  int exponent = 0;
  std::frexp(largest, &exponent);
  exponent = std::clamp(exponent, -1000, 1000);
  const double scale = std::ldexp(1.0, -exponent);
  for (auto* triangles : {&from, &to})
    for (triangle_points& t : *triangles)
      for (vec3& x : t) x *= scale;
  const double num_cuts = options.max_cuts * static_cast<double>(from.size() + to.size());
  const core::triangle_tree tree(std::move(to));
  distance_search search(tree, options.tolerance);
  search.start(from);
  const distance_bounds squared = search.run(num_cuts);
  return {std::ldexp(std::sqrt(squared.lower), exponent), std::ldexp(std::sqrt(squared.upper), exponent)};
}

}  // namespace concino::detail
