// Defines enclosing_ball.hpp. Points outside of the ball of those before them are on the boundary of the ball with
// them, so at most four points determine it.
#pragma once

#include <concino/core/error.hpp>
#include <concino/geometry/enclosing_ball.hpp>
#include <concino/geometry/support/flat_polygon.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace concino::detail {

/// The smallest ball around points of a size near 1.
class ball_search {
  std::vector<vec3> points_;
  std::array<vec3, 4> support_;  // what the ball has to have on its boundary; the first one is the origin
  std::array<vec3, 3> axes_;     // orthogonal directions that span the support, of length 1
  vec3 centre_;
  double squared_ = -1;

  bool holds(const vec3& x) const {
    const vec3 d = x - centre_;
    return dot(d, d) <= squared_ * (1 + 1e-14);
  }

  /// Whether the ball through the support with x added is defined; makes it the ball if so.
  bool pass_through(const vec3& x, unsigned n) {
    support_[n] = x;
    if (n == 0) {
      centre_ = x;
      squared_ = 0;
      return true;
    }
    // The new centre is the old one, moved along the part of the new direction that is orthogonal to the others.
    const vec3 from_first = x - support_[0];
    vec3 orthogonal = from_first;
    for (int twice = 0; twice < 2; ++twice)
      for (unsigned k = 0; k + 1 < n; ++k) orthogonal -= dot(orthogonal, axes_[k]) * axes_[k];
    const double height = norm(orthogonal);
    if (!(height > 1e-10 * norm(from_first))) return false;
    axes_[n - 1] = orthogonal / height;
    const vec3 to_centre = centre_of_support(n) - support_[0], to_x = from_first - to_centre;
    const double along = (dot(to_x, to_x) - dot(to_centre, to_centre)) / (2 * height);
    centre_ = support_[0] + to_centre + along * axes_[n - 1];
    squared_ = dot(centre_ - support_[0], centre_ - support_[0]);
    return true;
  }

  /// The centre of the smallest ball that has the first n points of the support on its boundary.
  vec3 centre_of_support(unsigned n) const {
    vec3 centre = support_[0];
    for (unsigned k = 1; k < n; ++k) {
      const vec3 to_x = support_[k] - centre, to_first = support_[0] - centre;
      centre += (dot(to_x, to_x) - dot(to_first, to_first)) / (2 * dot(support_[k] - support_[0], axes_[k - 1])) *
                axes_[k - 1];
    }
    return centre;
  }

  /// The smallest ball around the first `end` points that has the first n points of the support on its boundary.
  void search(std::size_t end, unsigned n) {
    for (std::size_t i = 0; i < end; ++i) {
      if (holds(points_[i])) continue;
      const vec3 x = points_[i], old_centre = centre_;
      const double old_squared = squared_;
      if (!pass_through(x, n)) {  // by rounding errors
        centre_ = old_centre;
        squared_ = old_squared;
        continue;
      }
      if (n < 3) search(i, n + 1);
      for (std::size_t k = i; k > 0; --k) points_[k] = points_[k - 1];
      points_[0] = x;
    }
  }

 public:
  explicit ball_search(std::vector<vec3> points) : points_(std::move(points)) {
    std::uint64_t random = 1;
    for (std::size_t i = points_.size(); i > 1; --i) {
      random = random * 6364136223846793005u + 1442695040888963407u;
      std::swap(points_[i - 1], points_[(random >> 33) % i]);
    }
    search(points_.size(), 0);
  }
  const vec3& centre() const { return centre_; }
  /// The largest distance of a point from the centre.
  double radius() const {
    double r = -1;
    for (const vec3& x : points_) r = std::max(r, norm(x - centre_));
    return r;
  }
};

inline void require_finite_points(std::span<const vec3> points, const char* who) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!is_finite(points[i]))
      core::throw_joined<invalid_argument>({who, ": point ", i, " is not finite; leave it out"});
}

}  // namespace concino::detail

namespace concino {

CONCINO_INLINE enclosing_ball_result enclosing_ball(std::span<const vec3> points) {
  detail::require_finite_points(points, "enclosing_ball");
  if (points.empty()) return {};
  const detail::local_frame frame([&](auto&& visit) {
    for (const vec3& x : points) visit(x);
  });
  std::vector<vec3> local;
  for (const vec3& x : points) local.push_back(frame(x));
  // The distances are those from the centre as it is returned, which is rounded where coordinates are large.
  const vec3 centre = frame.from_local(detail::ball_search(std::move(local)).centre()), near = frame(centre);
  double radius = 0;
  for (const vec3& x : points) radius = std::max(radius, norm(frame(x) - near));
  return {centre, frame.from_local(radius, 1)};
}

CONCINO_INLINE enclosing_circle_result enclosing_circle(std::span<const vec3> polygon) {
  detail::require_finite_points(polygon, "enclosing_circle");
  const core::flat_polygon flat(polygon);
  if (!(flat.area() > 0)) {
    const enclosing_ball_result ball = enclosing_ball(polygon);
    return {ball.centre, ball.radius, {}};
  }
  const detail::ball_search found(flat.corners());
  return {flat.to_space(found.centre()), flat.to_space(found.radius(), 1), flat.normal()};
}

}  // namespace concino
