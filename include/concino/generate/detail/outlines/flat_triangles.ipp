// Bodies of flat_triangles.hpp: triangulations of polygons without flat triangles, where corners may be collinear.
#pragma once

#include <concino/generate/detail/outlines/flat_triangles.hpp>

#include <algorithm>
#include <cmath>

namespace concino::detail {

// Scales the corners to about 1. Returns whether the polygon has a vector area.
CONCINO_INLINE bool polygon_cutter::set_corners(std::span<const vec3> corners) {
  double size = 0;
  for (const vec3& x : corners)
    size = std::max({size, std::abs(x.x - corners[0].x), std::abs(x.y - corners[0].y), std::abs(x.z - corners[0].z)});
  if (!(size > 0) || !std::isfinite(size)) return false;
  corners_.clear();
  for (const vec3& x : corners) corners_.push_back((x - corners[0]) / size);
  normal_ = {};
  for (std::size_t k = 2; k < corners_.size(); ++k) normal_ += cross(corners_[k - 1], corners_[k]);
  const double length = norm(normal_);
  normal_ /= length;
  return length > 0;
}

CONCINO_INLINE double polygon_cutter::squared_length(index a, index b) const {
  const vec3 d = corners_[b] - corners_[a];
  return dot(d, d);
}

CONCINO_INLINE bool polygon_cutter::is_flat(const polygon_triangle& t) const {
  const double doubled_area = dot(cross(corners_[t[1]] - corners_[t[0]], corners_[t[2]] - corners_[t[0]]), normal_);
  return !(doubled_area >
           1e-12 * std::max({squared_length(t[0], t[1]), squared_length(t[1], t[2]), squared_length(t[2], t[0])}));
}

CONCINO_INLINE void polygon_cutter::enter(std::size_t t) {
  for (const std::size_t k : {0u, 1u, 2u}) triangle_at_[{triangles_[t][k], triangles_[t][(k + 1) % 3]}] = t;
}

CONCINO_INLINE bool polygon_cutter::flip(std::size_t t) {
  const polygon_triangle& old = triangles_[t];
  std::size_t k = 0;  // the longest edge is opposite corner k
  for (const std::size_t i : {1u, 2u})
    if (squared_length(old[(i + 1) % 3], old[(i + 2) % 3]) > squared_length(old[(k + 1) % 3], old[(k + 2) % 3])) k = i;
  const index b = old[k], c = old[(k + 1) % 3], a = old[(k + 2) % 3];
  const auto found = triangle_at_.find({a, c});
  if (found == triangle_at_.end()) return false;
  const std::size_t other = found->second;
  index d = a;
  for (const index x : triangles_[other])
    if (x != a && x != c) d = x;
  const polygon_triangle one{a, b, d}, two{b, c, d};
  if (is_flat(one) || is_flat(two)) return false;
  triangle_at_.erase({a, c});
  triangle_at_.erase({c, a});
  triangles_[t] = one, triangles_[other] = two;
  enter(t), enter(other);
  return true;
}

CONCINO_INLINE void polygon_cutter::flip_all() {
  flat_.clear();
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    if (is_flat(triangles_[t])) flat_.push_back(t);
  if (flat_.empty()) return;
  triangle_at_.clear();
  for (std::size_t t = 0; t < triangles_.size(); ++t) enter(t);
  bool any = true;
  while (any && !flat_.empty()) {  // a flat triangle beside another one waits until that one is flipped
    any = false;
    left_.clear();
    for (const std::size_t t : flat_) {
      if (!is_flat(triangles_[t])) continue;
      if (flip(t)) any = true;
      else left_.push_back(t);
    }
    flat_.swap(left_);
  }
}

CONCINO_INLINE std::span<const polygon_triangle> polygon_cutter::operator()(std::span<const vec3> corners) {
  const auto triangles = triangulate_(corners);
  if (corners.size() <= 4 || !set_corners(corners)) return triangles;
  triangles_.assign(triangles.begin(), triangles.end());
  flip_all();
  return triangles_;
}

}  // namespace concino::detail
