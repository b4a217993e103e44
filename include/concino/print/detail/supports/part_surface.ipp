// Defines part_surface.hpp.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/geometry/bounding_box.hpp>
#include <concino/print/detail/supports/part_surface.hpp>

#include <algorithm>
#include <limits>

namespace concino::detail {

CONCINO_INLINE const std::vector<bool>& part_builder::finish() {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  double farthest = 0, size = 0;
  for (const vec3& x : points_) farthest = std::max({farthest, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
  if (farthest > 0x1p1020) surface_.shrink = 0.0625;  // differences would overflow
  box bounds;
  for (const vec3& x : points_) bounds.add(surface_.shrink * x);
  if (!bounds.is_empty()) {
    surface_.origin = bounds.min;
    const vec3 extent = bounds.max - bounds.min;
    size = std::max({extent.x, extent.y, extent.z});
  }
  if (size > 0) surface_.exponent = std::ilogb(size) + 1;
  surface_.tolerance = 4 * epsilon * (1 + std::ldexp(surface_.shrink * farthest, -surface_.exponent));

  std::vector<vec3> scaled, polygon;
  for (const vec3& x : points_) scaled.push_back(surface_.from_mesh(x));
  constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> numbers(points_.size(), none);
  polygon_triangulator cut;
  for (std::size_t p = 0; p + 1 < offsets_.size(); ++p) {
    const std::uint32_t first = offsets_[p], n = offsets_[p + 1] - first;
    polygon.clear();
    vec3 doubled;
    double longest = 0;
    for (std::uint32_t i = 0; i < n; ++i) polygon.push_back(scaled[corners_[first + i]]);
    for (std::uint32_t i = 1; i < n; ++i) {
      longest = std::max(longest, distance(polygon[i], polygon[0]));
      doubled += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    }
    has_area_.push_back(norm(doubled) > 2 * surface_.tolerance * longest);
    if (!has_area_.back()) continue;
    for (std::uint32_t i = 0; i < n; ++i) {
      std::uint32_t& number = numbers[corners_[first + i]];
      if (number != none) continue;
      number = static_cast<std::uint32_t>(surface_.points.size());
      surface_.points.push_back(scaled[corners_[first + i]]);
    }
    for (const polygon_triangle& t : cut(polygon)) {
      const std::array<std::uint32_t, 3> verts{numbers[corners_[first + t[0]]], numbers[corners_[first + t[1]]],
                                               numbers[corners_[first + t[2]]]};
      // of a polygon that passes a vert twice
      if (verts[0] == verts[1] || verts[1] == verts[2] || verts[2] == verts[0]) continue;
      surface_.triangles.push_back(verts);
      surface_.owners.push_back(static_cast<std::uint32_t>(surface_.areas.size()));
    }
    surface_.areas.push_back(0.5 * doubled);
  }
  return has_area_;
}

CONCINO_INLINE void part_builder::require_outward(const char* caller) const {
  vec3 sum;
  double area = 0, six_volumes = 0;
  for (const vec3& a : surface_.areas) sum += a, area += norm(a);
  if (!(norm(sum) <= 1e-9 * area)) return;  // the surface is open: it has no inside
  for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
    const auto [a, b, c] = surface_.triangle(t);
    six_volumes += dot(cross(a, b), c);
  }
  if (six_volumes < -1e-9)
    core::throw_joined<invalid_mesh>(
        {caller, ": the surface is inside out: its normals point inward; flip_winding(m) turns a surface"});
}

}  // namespace concino::detail
