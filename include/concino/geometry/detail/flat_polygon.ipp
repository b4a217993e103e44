// Defines flat_polygon.hpp. Edges that touch are found by a sweep along x, with exact tests.
#pragma once

#include <concino/core/error.hpp>
#include <concino/geometry/orientation.hpp>
#include <concino/geometry/support/flat_polygon.hpp>

#include <algorithm>
#include <limits>
#include <string>

namespace concino::core {

CONCINO_INLINE flat_polygon::flat_polygon(std::span<const vec3> points)
    : frame_([&](auto&& visit) {
        for (const vec3& x : points) visit(x);
      }) {
  if (!is_finite()) return;
  std::vector<vec3> local;
  for (const vec3& x : points) local.push_back(frame_(x));
  vec3 doubled;
  double magnitude = 0;
  for (std::size_t i = 1; i + 1 < local.size(); ++i) {
    const vec3 part = cross(local[i], local[i + 1]);
    doubled += part;
    magnitude += norm(part);
  }
  const double size = norm(doubled);
  if (size > 16 * std::numeric_limits<double>::epsilon() * magnitude) {
    area_ = size / 2;
    normal_ = doubled / size;
    u_ = std::abs(normal_.x) < 0.6 ? vec3{1, 0, 0} : vec3{0, 1, 0};
    u_ -= dot(u_, normal_) * normal_;
    u_ /= norm(u_);
    v_ = cross(normal_, u_);
  }
  for (const vec3& x : local) {
    corners_.push_back({dot(x, u_), dot(x, v_), 0});
    height_ += dot(x, normal_) / static_cast<double>(local.size());
  }
}

/// Whether two edges of a polygon without a common corner meet, by exact tests.
inline bool do_segments_meet(const vec3& a, const vec3& b, const vec3& c, const vec3& d) {
  const int of_c = orient2d(a, b, c), of_d = orient2d(a, b, d);
  if (of_c == 0 && of_d == 0) {  // on one line
    const auto overlap = [](double p, double q, double r, double s) {
      return std::max(std::min(p, q), std::min(r, s)) <= std::min(std::max(p, q), std::max(r, s));
    };
    return overlap(a.x, b.x, c.x, d.x) && overlap(a.y, b.y, c.y, d.y);
  }
  return of_c * of_d <= 0 && orient2d(c, d, a) * orient2d(c, d, b) <= 0;
}

CONCINO_INLINE std::optional<two_edges> flat_polygon::find_touching_edges() const {
  const std::size_t n = corners_.size();
  const auto end = [&](std::size_t i) -> const vec3& { return corners_[i + 1 == n ? 0 : i + 1]; };
  const auto low = [&](std::size_t i) { return std::min(corners_[i].x, end(i).x); };
  const auto high = [&](std::size_t i) { return std::max(corners_[i].x, end(i).x); };
  for (std::size_t i = 0; i < n; ++i)
    if (corners_[i] == end(i)) return two_edges{i, i};
  const auto touch = [&](std::size_t i, std::size_t j) {
    for (const auto& [first, second] : {two_edges{i, j}, two_edges{j, i}})
      if (second == (first + 1 == n ? 0 : first + 1)) {
        const vec3 &a = corners_[first], &b = corners_[second], &c = end(second);
        return orient2d(a, b, c) == 0 && dot(a - b, c - b) > 0;  // the second goes back along the first
      }
    return do_segments_meet(corners_[i], end(i), corners_[j], end(j));
  };
  std::vector<std::size_t> order(n), active;
  for (std::size_t i = 0; i < n; ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return low(i) != low(j) ? low(i) < low(j) : i < j;
  });
  for (const std::size_t i : order) {
    std::erase_if(active, [&](std::size_t j) { return high(j) < low(i); });
    for (const std::size_t j : active)
      if (touch(i, j)) return two_edges{std::min(i, j), std::max(i, j)};
    active.push_back(i);
  }
  return {};
}

/// What is wrong with a polygon of which a function needs the inside; empty if nothing is.
inline std::string defect_of(const flat_polygon& flat, std::span<const vec3> points) {
  if (points.size() < 3) return joined({" has ", points.size(), " corners; 3 are the fewest"});
  if (!flat.is_finite()) {
    std::size_t i = 0;
    while (is_finite(points[i])) ++i;
    return joined({" has a corner that is not finite, number ", i});
  }
  if (const auto found = flat.find_touching_edges()) {
    const auto [i, j] = *found;
    if (i == j) return joined({" has two equal corners, number ", i, " and the next one"});
    return joined({" touches itself: its edges from corners ", i, " and ", j, " meet"});
  }
  return flat.area() > 0 ? "" : " has no area";
}

CONCINO_INLINE flat_polygon checked_simple_polygon(std::span<const vec3> points, const char* who) {
  flat_polygon flat(points);
  const std::string defect = defect_of(flat, points);
  if (!defect.empty())
    throw_joined<invalid_argument>(
        {who, ": the polygon", defect, "; give one that is simple, seen along its vector area"});
  return flat;
}

CONCINO_INLINE flat_polygon checked_simple_polygon(std::span<const vec3> points, const char* who, std::size_t poly) {
  flat_polygon flat(points);
  const std::string defect = defect_of(flat, points);
  if (!defect.empty()) throw_joined<invalid_mesh>({who, ": poly ", poly, defect, "; validate(m) finds such polys"});
  return flat;
}

}  // namespace concino::core
