// Normals at the corners of polygons: smooth where the surface is smooth, and different on the two polygons at a
// crease.
#pragma once

#include <concino/core/parallel.hpp>
#include <concino/core/vec3.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino {

/// Polygons as flat arrays: polygon p has the corners offsets[p] .. offsets[p+1]-1, and corners[i] is the index of a
/// point.
struct polygon_list {
  std::span<const vec3> points;
  std::span<const std::uint32_t> offsets;
  std::span<const std::uint32_t> corners;

  std::size_t size() const { return offsets.empty() ? 0 : offsets.size() - 1; }
};

namespace detail {

using normal3 = std::array<float, 3>;

inline normal3 to_normal3(const vec3& n) {
  return {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
}

inline double angle_at(const vec3& before, const vec3& at, const vec3& after) {
  const vec3 a = before - at, b = after - at;
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

/// The unit normals of polygons: normalised vector areas, 0 for polygons without area.
inline std::vector<normal3> polygon_normals(const polygon_list& list) {
  std::vector<normal3> normals(list.size());
  parallel_for(list.size(), [&](std::size_t p) {
    const std::size_t first = list.offsets[p], last = list.offsets[p + 1];
    vec3 n;
    for (std::size_t c = first + 2; c < last; ++c) {
      const vec3& o = list.points[list.corners[first]];
      n += cross(list.points[list.corners[c - 1]] - o, list.points[list.corners[c]] - o);
    }
    const double length = norm(n);
    normals[p] = length > 0 && std::isfinite(length) ? to_normal3(n / length) : normal3{0, 0, 0};
  });
  return normals;
}

}  // namespace detail

/// The normal at every corner: the mean of the normals of polygons around its point that are similar to that of its own
/// polygon.
/// Needs:  crease_angle in degrees: polygons whose normals differ by more do not share a normal. Corners below the
///         number of points, offsets that do not decrease and end with the number of corners.
/// Result: one unit vector per corner. It is the normal of the polygon if there are no similar ones, and 0 if the
///         polygon has no area.
/// Cost:   O(sum of squared valences), less where more than 64 corners meet; parallel.
/// Errors: none.
/// Source: weights are the corners' angles, Thuerrner and Wuethrich 1998, so that the result does not depend on how
///         flat parts are divided.
inline std::vector<std::array<float, 3>> smooth_normals(const polygon_list& list, double crease_angle) {
  using detail::normal3;
  const auto polygon = detail::polygon_normals(list);
  const std::size_t n = list.corners.size();
  std::vector<normal3> normals(n);
  std::vector<float> angle(n);
  std::vector<std::uint32_t> polygon_of(n), around(n), starts(list.points.size() + 1, 0);
  parallel_for(list.size(), [&](std::size_t p) {
    const std::size_t first = list.offsets[p], last = list.offsets[p + 1];
    for (std::size_t c = first; c < last; ++c) {
      const std::size_t before = c == first ? last - 1 : c - 1, after = c + 1 == last ? first : c + 1;
      const auto at = [&](std::size_t i) -> const vec3& { return list.points[list.corners[i]]; };
      angle[c] = static_cast<float>(detail::angle_at(at(before), at(c), at(after)));
      polygon_of[c] = static_cast<std::uint32_t>(p);
    }
  });
  for (const std::uint32_t v : list.corners) ++starts[v + 1];
  for (std::size_t v = 1; v < starts.size(); ++v) starts[v] += starts[v - 1];
  {
    std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
    for (std::size_t c = 0; c < n; ++c) around[next[list.corners[c]]++] = static_cast<std::uint32_t>(c);
  }

  const double cosine = std::cos(crease_angle * 3.14159265358979323846 / 180);
  parallel_for(
      list.points.size(),
      [&](std::size_t v) {
        const std::span<const std::uint32_t> ring(around.data() + starts[v], around.data() + starts[v + 1]);
        const auto normal_of = [&](std::uint32_t c) { return to_vec3(polygon[polygon_of[c]]); };
        const auto mean = [&](const vec3& like, double at_least) {
          vec3 sum;
          for (const std::uint32_t c : ring)
            if (dot(normal_of(c), like) >= at_least) sum += normal_of(c) * static_cast<double>(angle[c]);
          return sum;
        };
        const bool many = ring.size() > 64;
        const vec3 all = many ? mean({}, -1) : vec3{};
        for (const std::uint32_t c : ring) {
          const vec3 own = normal_of(c), sum = many ? all : mean(own, cosine);
          const double length = norm(sum);
          const bool fits = length > 0 && (!many || dot(own, sum) >= cosine * length);
          normals[c] = fits ? detail::to_normal3(sum / length) : polygon[polygon_of[c]];
        }
      },
      256);
  return normals;
}

}  // namespace concino
