// Defines hausdorff_distance.hpp. The distance from a triangle is a convex function, so on a convex polygon it is largest at a corner. That gives an upper bound
// for each polygon from any of the triangles near it. Only polygons whose bound exceeds the largest distance met so far are cut into smaller ones.
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

  const triangle_points& triangle(std::size_t i) const { return triangles_[i]; }
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

/// A convex part of a triangle. The squared distances of its points are at most `upper`.
struct polygon_part {
  static constexpr unsigned max_corners = 10;
  static constexpr double unit = 0x1p-46;  // distances are no more exact than this, in coordinates of at most 1

  std::array<vec3, max_corners> corners;
  unsigned n = 0;
  std::size_t candidate = 0;  // the triangle nearest to the mean of the corners
  double upper = std::numeric_limits<double>::infinity();

  bool operator<(const polygon_part& other) const { return upper < other.upper; }
  void add(const vec3& x) { corners[n++] = x; }
  vec3 mean() const {
    vec3 sum;
    for (unsigned k = 0; k < n; ++k) sum += corners[k];
    return sum / n;
  }

  /// Finds the candidate and the bounds that follow from it. Returns the squared distance of the mean.
  double bound(const triangle_tree& to, std::size_t guess) {
    const vec3 x = mean();
    const auto found = to.nearest(x, guess);
    candidate = found.triangle;
    double most = 0, reach = 0;
    for (unsigned k = 0; k < n; ++k) {
      most = std::max(most, to.squared_distance(corners[k], candidate));
      reach = std::max(reach, distance(x, corners[k]));
    }
    const double around = std::sqrt(found.squared) + reach;
    upper = std::min({upper, most, around * around});
    return found.squared;
  }

  /// Splits at the plane through `at` with normal m: what is behind it and what is before it. Both are empty if up to rounding all corners are on one side.
  std::array<polygon_part, 2> split(const vec3& at, const vec3& m) const {
    std::array<polygon_part, 2> sides;
    for (polygon_part& p : sides) p.upper = upper, p.candidate = candidate;
    const auto height = [&](const vec3& x) { return dot(x - at, m); };
    double least = 0, most = 0;
    for (unsigned k = 0; k < n; ++k) least = std::min(least, height(corners[k])), most = std::max(most, height(corners[k]));
    if (!(std::min(-least, most) > unit * norm(m))) return sides;
    for (unsigned k = 0; k < n; ++k) {
      const vec3 &x = corners[k], &y = corners[k + 1 < n ? k + 1 : 0];
      const double hx = height(x), hy = height(y);
      if (hx <= 0) sides[0].add(x);
      if (hx >= 0) sides[1].add(x);
      if ((hx < 0 && hy > 0) || (hx > 0 && hy < 0)) {
        const vec3 between = x + hx / (hx - hy) * (y - x);
        for (polygon_part& p : sides) p.add(between);
      }
    }
    return sides;
  }
  /// Splits into halves of about equal length.
  std::array<polygon_part, 2> halves() const {
    unsigned i = 0, j = 1;
    for (unsigned k = 0; k < n; ++k)
      for (unsigned l = k + 1; l < n; ++l)
        if (distance(corners[k], corners[l]) > distance(corners[i], corners[j])) i = k, j = l;
    return split((corners[i] + corners[j]) / 2, corners[j] - corners[i]);
  }
};

class distance_search {
  const triangle_tree& to_;
  std::vector<polygon_part> parts_;  // a heap: those that may have a larger distance than `lower_`
  double lower_ = 0;
  double done_ = 0;  // the upper bound of the parts that were left out because they hardly exceed the lower one
  double enough_;    // bounds may differ by this factor

  bool matters(double upper) const { return upper > enough_ * lower_ && upper > polygon_part::unit * polygon_part::unit; }

  void add(const polygon_part& p) {
    if (!matters(p.upper)) {
      done_ = std::max(done_, p.upper);
      return;
    }
    parts_.push_back(p);
    std::push_heap(parts_.begin(), parts_.end());
  }
  void bound_and_add(polygon_part& p) {
    lower_ = std::max(lower_, p.bound(to_, p.candidate));
    add(p);
  }
  /// Splits a part at the edges of its candidate, seen along the normal of that: the part above the candidate has no other bound than its distance from it. If that
  /// splits nothing, the part is halved.
  void cut(polygon_part p) {
    const triangle_points& t = to_.triangle(p.candidate);
    const vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
    bool any = false;
    for (std::size_t k = 0; k < 3 && p.n + 1 < polygon_part::max_corners; ++k) {
      auto [inside, outside] = p.split(t[k], cross(t[k == 2 ? 0 : k + 1] - t[k], normal));
      if (inside.n < 3 || outside.n < 3) continue;
      bound_and_add(outside);
      p = inside;
      any = true;
    }
    if (any) return bound_and_add(p);
    auto halves = p.halves();
    if (halves[0].n < 3 || halves[1].n < 3) done_ = std::max(done_, p.upper);  // it is a point, up to rounding
    else for (polygon_part& half : halves) bound_and_add(half);
  }

 public:
  distance_search(const triangle_tree& to, double tolerance) : to_(to), enough_(1 / ((1 - tolerance) * (1 - tolerance))) {}

  void start(const std::vector<triangle_points>& from) {
    std::vector<polygon_part> all(from.size());
    std::vector<double> largest(from.size());
    parallel_for(from.size(), [&](std::size_t i) {
      for (const vec3& x : from[i]) all[i].add(x);
      largest[i] = all[i].bound(to_, 0);
      for (const vec3& x : from[i]) largest[i] = std::max(largest[i], to_.nearest(x, all[i].candidate).squared);
    }, 256);
    for (const double d : largest) lower_ = std::max(lower_, d);
    for (const polygon_part& p : all) add(p);
  }

  /// Squared bounds.
  distance_bounds run(double max_cuts) {
    for (double cuts = 0; cuts < max_cuts && !parts_.empty() && matters(parts_[0].upper); ++cuts) {
      std::pop_heap(parts_.begin(), parts_.end());
      const polygon_part p = parts_.back();
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
