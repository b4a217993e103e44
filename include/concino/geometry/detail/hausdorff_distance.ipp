// Defines hausdorff_distance.hpp. The distance from a triangle is a convex function, so on another triangle it is largest at a corner. That gives an upper bound
// for each triangle from any of the triangles near it. Only triangles whose bound exceeds the largest distance met so far are cut into smaller ones.
#pragma once

#include <concino/core/parallel.hpp>
#include <concino/geometry/closest_point.hpp>
#include <concino/geometry/detail/box_tree_build.hpp>
#include <concino/geometry/detail/tree_queries.hpp>
#include <concino/geometry/hausdorff_distance.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace concino::detail {

/// Triangles with a tree of their boxes.
class triangle_tree {
  std::vector<triangle_points> triangles_;
  box_tree boxes_;

 public:
  explicit triangle_tree(std::vector<triangle_points> triangles) {
    std::vector<std::uint32_t> order;
    boxes_ = build_box_tree(triangles.size(), 4, [&](std::size_t i) {
      box b;
      for (const vec3& x : triangles[i]) b.add(x);
      return b;
    }, order);
    arrange(triangles, order);
    triangles_ = std::move(triangles);
  }

  double squared_distance(const vec3& x, std::size_t i) const {
    const triangle_points& t = triangles_[i];
    const vec3 d = x - closest_point(x, t[0], t[1], t[2]);
    return dot(d, d);
  }

  struct place {
    std::size_t triangle;
    double squared;
  };
  /// The triangle nearest to x. The search is quick if `guess` is near.
  place nearest(const vec3& x, std::size_t guess) const {
    place best{guess, squared_distance(x, guess)};
    boxes_.search([&](const box_node& n) { return n.squared_distance(x); }, best.squared, [&](std::size_t i) {
      const triangle_points& t = triangles_[i];
      if (squared_distance_to_box(x, t[0], t[1], t[2]) >= best.squared) return;
      const double squared = squared_distance(x, i);
      if (squared < best.squared) best = {i, squared};
    });
    return best;
  }
};

/// A part of a triangle, with what is nearest to its corners. All distances in it are at most `upper`, squared.
struct triangle_part {
  triangle_points corners;
  std::array<triangle_tree::place, 3> nearest;
  double upper;

  bool operator<(const triangle_part& other) const { return upper < other.upper; }

  void lower_upper_bound(const triangle_tree& to, std::size_t candidate) {
    double most = 0;
    for (const vec3& x : corners) most = std::max(most, to.squared_distance(x, candidate));
    upper = std::min(upper, most);
  }
  /// The bounds that follow from the corners.
  void bound(const triangle_tree& to) {
    for (std::size_t k = 0; k < 3; ++k) {
      lower_upper_bound(to, nearest[k].triangle);
      double reach = 0;
      for (const vec3& x : corners) reach = std::max(reach, distance(x, corners[k]));
      const double most = std::sqrt(nearest[k].squared) + reach;
      upper = std::min(upper, most * most);
    }
  }
};

class distance_search {
  const triangle_tree& to_;
  std::vector<triangle_part> parts_;  // a heap: those that may have a larger distance than `lower_`
  double lower_ = 0;
  double done_ = 0;  // the upper bound of the parts that were left out because they hardly exceed the lower one
  double enough_;    // bounds may differ by this factor

  static constexpr double unit = 0x1p-46;  // distances are no more exact than this, in coordinates of at most 1

  bool matters(double upper) const { return upper > enough_ * lower_ && upper > unit * unit; }

  void cut(const triangle_part& whole) {
    std::array<triangle_part, 4> parts;
    std::array<vec3, 3> middle;  // middle[k] lies opposite to corner k
    std::array<triangle_tree::place, 3> near;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      middle[k] = (whole.corners[i] + whole.corners[j]) / 2;
      near[k] = to_.nearest(middle[k], whole.nearest[i].triangle);
      lower_ = std::max(lower_, near[k].squared);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      parts[k] = {{whole.corners[k], middle[j], middle[i]}, {whole.nearest[k], near[j], near[i]}, whole.upper};
    }
    parts[3] = {middle, near, whole.upper};
    for (triangle_part& p : parts) {
      p.bound(to_);
      add(p);
    }
  }

  void add(const triangle_part& p) {
    if (!matters(p.upper)) {
      done_ = std::max(done_, p.upper);
      return;
    }
    parts_.push_back(p);
    std::push_heap(parts_.begin(), parts_.end());
  }

 public:
  distance_search(const triangle_tree& to, double tolerance) : to_(to), enough_(1 / ((1 - tolerance) * (1 - tolerance))) {}

  void start(const std::vector<triangle_points>& from) {
    std::vector<triangle_part> all(from.size());
    parallel_for(from.size(), [&](std::size_t i) {
      const triangle_points& t = from[i];
      triangle_part& p = all[i];
      const auto middle = to_.nearest((t[0] + t[1] + t[2]) / 3, 0);
      p = {t, {}, std::numeric_limits<double>::infinity()};
      for (std::size_t k = 0; k < 3; ++k) p.nearest[k] = to_.nearest(t[k], middle.triangle);
      p.bound(to_);
      p.lower_upper_bound(to_, middle.triangle);
    }, 256);
    for (const triangle_part& p : all)
      for (const auto& place : p.nearest) lower_ = std::max(lower_, place.squared);
    for (const triangle_part& p : all) add(p);
  }

  /// Squared bounds.
  distance_bounds run(double max_cuts) {
    for (double cuts = 0; cuts < max_cuts && !parts_.empty() && matters(parts_[0].upper); ++cuts) {
      std::pop_heap(parts_.begin(), parts_.end());
      const triangle_part p = parts_.back();
      parts_.pop_back();
      cut(p);
    }
    return {lower_, std::max({lower_, done_, parts_.empty() ? 0 : parts_[0].upper})};
  }
};

CONCINO_INLINE distance_bounds distance_between(std::vector<triangle_points> from, std::vector<triangle_points> to, const hausdorff_options& options, const char* caller) {
  if (!(options.tolerance >= 0 && options.tolerance < 1)) core::throw_joined<invalid_argument>({caller, ": options.tolerance must be at least 0 and less than 1"});
  if (!(options.max_cuts >= 0)) core::throw_joined<invalid_argument>({caller, ": options.max_cuts is negative or not a number; it must be at least 0"});
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
  const triangle_tree tree(std::move(to));
  distance_search search(tree, options.tolerance);
  search.start(from);
  const distance_bounds squared = search.run(num_cuts);
  return {std::ldexp(std::sqrt(squared.lower), exponent), std::ldexp(std::sqrt(squared.upper), exponent)};
}

}  // namespace concino::detail
