// Defines what balls.hpp declares: spheres of triangles.
#pragma once

#include <concino/render/balls.hpp>
#include <concino/render/detail/shapes/shape_size.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace concino::detail {

/// Points and triangles of a sphere of radius 1 about the origin.
struct unit_sphere {
  std::vector<vec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  unit_sphere() {
    const double g = 1.61803398874989484820;
    points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
              {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                 {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                 {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (vec3& p : points) p /= norm(p);
  }

  void split_in_four() {
    std::unordered_map<std::uint64_t, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [it, added] = middles.try_emplace(std::uint64_t{std::min(a, b)} << 32 | std::max(a, b),
                                                   static_cast<std::uint32_t>(points.size()));
      if (added) {
        const vec3 p = points[a] + points[b];
        points.push_back(p / norm(p));
      }
      return it->second;
    };
    std::vector<std::array<std::uint32_t, 3>> finer;
    for (const auto& [a, b, c] : triangles) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    triangles.swap(finer);
  }
};

CONCINO_INLINE void check_ball_options(std::span<const vec3> centers, const ball_options& o) {
  const char* const caller = "make_balls";
  check_shape_option(o.radius >= 0 && std::isfinite(o.radius), caller, "the radius must be finite, and positive or 0",
                     o.radius);
  check_shape_option(o.opacity >= 0 && o.opacity <= 1, caller, "the opacity must be in [0, 1]", o.opacity);
  check_shape_option(
      o.triangles == 0 || o.triangles == 20 || o.triangles == 80 || o.triangles == 320 || o.triangles == 1280, caller,
      "triangles must be 0, 20, 80, 320 or 1280", o.triangles);
  const std::size_t n = centers.size();
  const auto check_number = [&](std::size_t number, const char* what) {
    if (number != 0 && number != n)
      core::throw_joined<invalid_argument>({caller, ": ", number, what, n, " points: give one for each point"});
  };
  check_number(o.values.size(), " values for ");
  check_number(o.colors.size(), " colours for ");
  check_number(o.radii.size(), " radii for ");
  check_radii(caller, o.radii);
  for (std::size_t i = 0; i < n; ++i)
    if (!is_finite(centers[i]))
      core::throw_joined<invalid_argument>(
          {caller, ": point ", i, " has a coordinate that is not a finite number: leave it out"});
}

CONCINO_INLINE drawable balls_at(std::span<const vec3> centers, const ball_options& o) {
  check_ball_options(centers, o);
  const std::size_t n = centers.size();
  const std::size_t wanted = o.triangles > 0 ? static_cast<std::size_t>(o.triangles)
                             : n <= 50       ? 1280
                             : n <= 1000     ? 320
                             : n <= 10000    ? 80
                                             : 20;
  unit_sphere sphere;
  while (sphere.triangles.size() < wanted) sphere.split_in_four();
  const double radius = shape_radius(o.radius, 0.008, centers);
  const std::size_t num_triangles = n * wanted, num_points = n * sphere.points.size();
  check_shape_size("make_balls", 3 * num_triangles);

  drawable d;
  d.look.color = o.color;
  d.look.map = o.map;
  d.look.opacity = o.opacity;
  d.look.scale = o.scale ? *o.scale : value_scale::linear(o.values);
  d.colors_at = value_place::points;
  d.points.reserve(num_points);
  if (!o.values.empty()) d.values.reserve(num_points);
  if (!o.colors.empty()) d.colors.reserve(num_points);
  d.offsets.reserve(num_triangles + 1);
  d.polys.reserve(num_triangles);
  d.corners.reserve(3 * num_triangles);
  d.normals.reserve(3 * num_triangles);
  d.triangles.reserve(num_triangles);
  d.polygon_of.reserve(num_triangles);
  for (std::size_t i = 0; i < n; ++i) {
    const auto base = static_cast<std::uint32_t>(d.points.size());
    for (const vec3& p : sphere.points) d.points.push_back(centers[i] + p * (o.radii.empty() ? radius : o.radii[i]));
    if (!o.values.empty()) d.values.insert(d.values.end(), sphere.points.size(), o.values[i]);
    if (!o.colors.empty()) d.colors.insert(d.colors.end(), sphere.points.size(), o.colors[i]);
    for (const auto& triangle : sphere.triangles) {
      const auto first = static_cast<std::uint32_t>(d.corners.size());
      for (const std::uint32_t k : triangle) {
        d.corners.push_back(base + k);
        d.normals.push_back(to_normal3(sphere.points[k]));
      }
      d.triangles.push_back({first, first + 1, first + 2});
      d.polygon_of.push_back(static_cast<std::uint32_t>(d.polys.size()));
      d.polys.push_back(static_cast<std::uint32_t>(i));
      d.offsets.push_back(first + 3);
    }
  }
  return d;
}

}  // namespace concino::detail
