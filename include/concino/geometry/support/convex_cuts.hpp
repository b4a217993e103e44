// Cuts convex polygons by lines and convex polyhedra by planes.
#pragma once

#include <concino/core/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace concino::core {

/// The part of a convex loop where height(x) >= 0. Calls met(x) for the points where it is cut.
template<class Height, class OnPlane>
void cut_convex_loop(std::vector<vec3>& loop, std::vector<vec3>& scratch, const Height& height,
                     const OnPlane& on_plane) {
  scratch.clear();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const vec3 a = loop[i], b = loop[i + 1 == loop.size() ? 0 : i + 1];
    const double ha = height(a), hb = height(b);
    if (ha >= 0) scratch.push_back(a);
    if (ha == 0) on_plane(a);
    if ((ha > 0 && hb < 0) || (ha < 0 && hb > 0)) {
      const vec3 x = a + (ha / (ha - hb)) * (b - a);
      scratch.push_back(x);
      on_plane(x);
    }
  }
  loop.swap(scratch);
}

/// The kernel of a polygon in the plane z = 0 with counter-clockwise corners.
struct flat_kernel {
  std::vector<vec3> corners;  // counter-clockwise; none if the kernel is empty
  bool is_whole = false;      // the polygon is convex: its kernel is all of it
};

/// Cuts the bounding box by the lines of all edges. Distances below flat_part of its size are rounding errors.
inline constexpr double flat_part = 1e-12;
inline flat_kernel kernel_of(const std::vector<vec3>& flat) {
  flat_kernel kernel;
  if (flat.empty()) return kernel;
  vec3 low = flat[0], high = low;
  for (const vec3& x : flat) {
    low = {std::min(low.x, x.x), std::min(low.y, x.y), 0};
    high = {std::max(high.x, x.x), std::max(high.y, x.y), 0};
  }
  kernel.corners = {low, {high.x, low.y, 0}, high, {low.x, high.y, 0}};
  kernel.is_whole = true;
  std::vector<vec3> scratch;
  const double eps = flat_part * std::max(high.x - low.x, high.y - low.y);
  for (std::size_t i = 0; i < flat.size() && !kernel.corners.empty(); ++i) {
    const vec3 a = flat[i];
    vec3 along = flat[i + 1 == flat.size() ? 0 : i + 1] - a;
    const double length = norm(along);
    if (length <= eps) continue;
    along /= length;
    const auto height = [&](const vec3& x) { return along.x * (x.y - a.y) - along.y * (x.x - a.x); };
    for (const vec3& x : flat) kernel.is_whole = kernel.is_whole && height(x) >= -eps;
    cut_convex_loop(kernel.corners, scratch, height, [](const vec3&) {});
  }
  if (kernel.is_whole) kernel.corners = flat;
  return kernel;
}

/// The area of a polygon in the plane z = 0.
inline double flat_area(const std::vector<vec3>& loop) {
  double doubled = 0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) doubled += cross(loop[i] - loop[0], loop[i + 1] - loop[0]).z;
  return doubled / 2;
}

/// A convex polyhedron as the loops of its faces, counter-clockwise seen from outside.
class convex_body {
  std::vector<std::vector<vec3>> faces_;
  std::vector<vec3> scratch_, section_;
  double eps_;  // points at smaller distances from a plane are on it

 public:
  /// A box between two corners.
  convex_body(const vec3& a, const vec3& b) : eps_(1e-14 * norm(b - a)) {
    const auto at = [&](unsigned k) { return vec3{k & 1u ? b.x : a.x, k & 2u ? b.y : a.y, k & 4u ? b.z : a.z}; };
    faces_ = {{at(0), at(2), at(3), at(1)}, {at(4), at(5), at(7), at(6)}, {at(0), at(1), at(5), at(4)},
              {at(2), at(6), at(7), at(3)}, {at(0), at(4), at(6), at(2)}, {at(1), at(3), at(7), at(5)}};
  }
  const std::vector<std::vector<vec3>>& faces() const { return faces_; }

  /// Keeps the part where dot(n, x - origin) <= 0; n has length 1.
  void cut(const vec3& n, const vec3& origin) {
    const auto depth = [&](const vec3& x) {
      const double d = dot(n, origin - x);
      return std::abs(d) <= eps_ ? 0 : d;
    };
    bool any = false;
    for (const auto& f : faces_)
      for (const vec3& x : f) any = any || depth(x) < 0;
    if (!any) return;
    section_.clear();
    for (auto& f : faces_)
      cut_convex_loop(f, scratch_, depth, [&](const vec3& x) { section_.push_back(x); });
    std::erase_if(faces_, [](const auto& f) { return f.size() < 3; });
    if (section_.size() < 3) return;
    // The section is convex: its corners are in the order of their angles about a point inside.
    vec3 mean, e = std::abs(n.x) < 0.6 ? vec3{1, 0, 0} : vec3{0, 1, 0};
    for (const vec3& x : section_) mean += x / static_cast<double>(section_.size());
    e = cross(n, e);
    const vec3 f = cross(n, e);
    const auto angle = [&](const vec3& x) { return std::atan2(dot(x - mean, f), dot(x - mean, e)); };
    std::sort(section_.begin(), section_.end(), [&](const vec3& x, const vec3& y) { return angle(x) < angle(y); });
    faces_.push_back(section_);
  }

  double volume() const {
    double sum = 0;
    for (const auto& f : faces_)
      for (std::size_t i = 1; i + 1 < f.size(); ++i)
        sum += dot(f[0] - faces_[0][0], cross(f[i] - f[0], f[i + 1] - f[0]));
    return sum / 6;
  }
};

/// Calls f(n, x) for the planes of a face of a polyhedron, a loop of n points at(i): unit normals that point outward,
/// and a point. A face that is not planar has a plane for each triangle between an edge and its mean. What has no area,
/// at distances of eps, is left out.
template<class PointOf, class F>
void for_each_face_plane(std::size_t n, const PointOf& at, double eps, const F& f) {
  vec3 mean, doubled;
  for (std::size_t i = 0; i < n; ++i) {
    mean += (at(i) - at(0)) / static_cast<double>(n);
    doubled += cross(at(i) - at(0), at(i + 1 == n ? 0 : i + 1) - at(0));
  }
  mean += at(0);
  const double area = norm(doubled);
  bool planar = area > eps * eps;
  for (std::size_t i = 0; i < n && planar; ++i) planar = std::abs(dot(doubled, at(i) - mean)) <= 1e3 * eps * area;
  if (planar) f(doubled / area, mean);
  for (std::size_t i = 0; i < n && !planar; ++i) {
    const vec3 normal = cross(at(i) - mean, at(i + 1 == n ? 0 : i + 1) - mean);
    const double triangle = norm(normal);
    if (triangle > eps * eps) f(normal / triangle, mean);
  }
}

}  // namespace concino::core
