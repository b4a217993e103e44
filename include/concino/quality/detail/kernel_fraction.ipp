// Defines kernel_fraction.hpp: a convex polygon or polyhedron, first the bounding box, is cut by the lines or planes of
// all facets.
#pragma once

#include <concino/quality/detail/metric_row.hpp>
#include <concino/quality/detail/kernel_fraction.hpp>

#include <cmath>
#include <vector>

namespace concino::detail {

// Distances below this part of the size of the poly are rounding errors.
inline constexpr double flat_part = 1e-12;

/// The part of a convex loop where height(x) >= 0. Calls met(x) for the points where it is cut.
template<class Height, class Met>
void cut_convex_loop(std::vector<vec3>& loop, std::vector<vec3>& scratch, const Height& height, const Met& met) {
  scratch.clear();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const vec3 a = loop[i], b = loop[i + 1 == loop.size() ? 0 : i + 1];
    const double ha = height(a), hb = height(b);
    if (ha >= 0) scratch.push_back(a);
    if (ha == 0) met(a);
    if ((ha > 0 && hb < 0) || (ha < 0 && hb > 0)) {
      const vec3 x = a + (ha / (ha - hb)) * (b - a);
      scratch.push_back(x);
      met(x);
    }
  }
  loop.swap(scratch);
}

CONCINO_INLINE double kernel_fraction_of_polygon(std::span<const vec3> points, const vec3& area) {
  const double size = norm(area);
  if (!(size > 0)) return 0;
  const vec3 n = area / size;
  vec3 e = std::abs(n.x) < 0.6 ? vec3{1, 0, 0} : vec3{0, 1, 0};
  e -= dot(e, n) * n;
  e /= norm(e);
  const vec3 f = cross(n, e);
  std::vector<vec3> flat;
  vec3 low{no_limit, no_limit, 0}, high{-no_limit, -no_limit, 0};
  for (const vec3& p : points) {
    const vec3 x{dot(p - points[0], e), dot(p - points[0], f), 0};
    flat.push_back(x);
    low = {std::min(low.x, x.x), std::min(low.y, x.y), 0}, high = {std::max(high.x, x.x), std::max(high.y, x.y), 0};
  }
  std::vector<vec3> kernel = {low, {high.x, low.y, 0}, high, {low.x, high.y, 0}}, scratch;
  const double eps = flat_part * std::max(high.x - low.x, high.y - low.y);
  bool convex = true;
  for (std::size_t i = 0; i < flat.size() && !kernel.empty(); ++i) {
    const vec3 a = flat[i];
    vec3 along = flat[i + 1 == flat.size() ? 0 : i + 1] - a;
    const double length = norm(along);
    if (length <= eps) continue;
    along /= length;
    const auto height = [&](const vec3& x) { return along.x * (x.y - a.y) - along.y * (x.x - a.x); };
    for (const vec3& x : flat) convex = convex && height(x) >= -eps;
    cut_convex_loop(kernel, scratch, height, [](const vec3&) {});
  }
  double doubled = 0;
  for (std::size_t i = 1; i + 1 < kernel.size(); ++i)
    doubled += cross(kernel[i] - kernel[0], kernel[i + 1] - kernel[0]).z;
  return convex ? 1 : std::clamp(doubled / (2 * size), 0.0, 1.0);
}

/// A convex polyhedron as the loops of its faces, counter-clockwise seen from outside.
class convex_body {
  std::vector<std::vector<vec3>> faces_;
  std::vector<vec3> scratch_, section_;

 public:
  convex_body(const vec3& a, const vec3& b) {
    const auto at = [&](unsigned k) { return vec3{k & 1u ? b.x : a.x, k & 2u ? b.y : a.y, k & 4u ? b.z : a.z}; };
    faces_ = {{at(0), at(2), at(3), at(1)}, {at(4), at(5), at(7), at(6)}, {at(0), at(1), at(5), at(4)},
              {at(2), at(6), at(7), at(3)}, {at(0), at(4), at(6), at(2)}, {at(1), at(3), at(7), at(5)}};
  }

  /// Keeps the part where dot(n, x - origin) <= 0; n has length 1.
  void cut(const vec3& n, const vec3& origin) {
    bool any = false;
    for (const auto& f : faces_)
      for (const vec3& x : f) any = any || dot(n, x - origin) > 0;
    if (!any) return;
    section_.clear();
    for (auto& f : faces_)
      cut_convex_loop(
          f, scratch_, [&](const vec3& x) { return -dot(n, x - origin); },
          [&](const vec3& x) { section_.push_back(x); });
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

/// Calls f(n, x) for the planes of all facets of a polyhedron: unit normals that point outward, and a point. A face
/// that is not planar has a plane for each triangle between an edge and its mean. What has no area is left out.
template<class F>
void for_each_facet_plane(const poly_geometry& g, double eps, const F& f) {
  for (std::size_t k = 0; k + 1 < g.face_begins.size(); ++k) {
    const auto face = g.face_verts.subspan(g.face_begins[k], g.face_begins[k + 1] - g.face_begins[k]);
    const auto at = [&](std::size_t i) -> const vec3& { return g.points[face[i == face.size() ? 0 : i]]; };
    vec3 mean, doubled;
    for (std::size_t i = 0; i < face.size(); ++i) {
      mean += (at(i) - at(0)) / static_cast<double>(face.size());
      doubled += cross(at(i) - at(0), at(i + 1) - at(0));
    }
    mean += at(0);
    const double area = norm(doubled);
    bool planar = area > eps * eps;
    for (std::size_t i = 0; i < face.size() && planar; ++i)
      planar = std::abs(dot(doubled, at(i) - mean)) <= 1e3 * eps * area;
    if (planar) f(doubled / area, mean);
    for (std::size_t i = 0; i < face.size() && !planar; ++i) {
      const vec3 n = cross(at(i) - mean, at(i + 1) - mean);
      const double triangle = norm(n);
      if (triangle > eps * eps) f(n / triangle, mean);
    }
  }
}

CONCINO_INLINE double kernel_fraction_of_polyhedron(const poly_geometry& g, double volume) {
  if (!(volume > 0)) return 0;
  vec3 low = g.points[0], high = low;
  for (const vec3& x : g.points)
    for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], x[k]), high[k] = std::max(high[k], x[k]);
  const double eps = flat_part * std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  bool convex = true;
  for_each_facet_plane(g, eps, [&](const vec3& n, const vec3& origin) {
    for (const vec3& x : g.points) convex = convex && dot(n, x - origin) <= 1e3 * eps;
  });
  if (convex) return 1;
  convex_body kernel(low, high);
  for_each_facet_plane(g, eps, [&](const vec3& n, const vec3& origin) { kernel.cut(n, origin); });
  return std::clamp(kernel.volume() / volume, 0.0, 1.0);
}

}  // namespace concino::detail
