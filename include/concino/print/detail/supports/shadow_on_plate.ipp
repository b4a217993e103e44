// Defines shadow_on_plate.hpp. Each triangle, seen counter-clockwise, covers its points once, and what is covered a
// positive number of times is the shadow. Edges that two triangles pass in opposite directions change no number, so
// only those where the surface turns away remain.
#pragma once

#include <concino/geometry/orientation.hpp>
#include <concino/print/detail/regions/disjoint_regions.hpp>
#include <concino/print/detail/regions/lattice.hpp>
#include <concino/print/detail/slices/section_lines.hpp>
#include <concino/print/detail/supports/build_frame.hpp>
#include <concino/print/shadow_on_plate.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace concino::detail {

/// Numbers points of a lattice, equal ones alike. Returns the number of each; `points` then has each once.
inline std::vector<std::uint32_t> number_positions(std::vector<snapped_point>& points) {
  std::vector<std::uint32_t> order(points.size()), number(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t i, std::uint32_t j) { return std::pair(points[i], i) < std::pair(points[j], j); });
  std::vector<snapped_point> found;
  for (const std::uint32_t i : order) {
    if (found.empty() || found.back() != points[i]) found.push_back(points[i]);
    number[i] = static_cast<std::uint32_t>(found.size() - 1);
  }
  points = std::move(found);
  return number;
}

/// The boundary of the sum of triangles on a lattice, as closed paths. Where all its edges occur n times, once is
/// enough: twice in a closed surface, whose upper and lower sides have the same shadow.
inline lattice_paths outline_of_triangles(std::vector<snapped_point> points,
                                          const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  const std::vector<std::uint32_t> number = number_positions(points);
  const auto position = [&](std::uint32_t i) {
    return vec3{static_cast<double>(points[i][0]), static_cast<double>(points[i][1]), 0};
  };
  std::vector<std::array<std::uint32_t, 3>> edges;  // the smaller end, the larger one, 1 if it runs from this to that
  for (const auto& t : triangles) {
    std::array<std::uint32_t, 3> v{number[t[0]], number[t[1]], number[t[2]]};
    const int turn = orient2d(position(v[0]), position(v[1]), position(v[2]));
    if (turn == 0) continue;
    if (turn < 0) std::swap(v[1], v[2]);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = v[k], b = v[(k + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), a < b ? 0u : 1u});
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<std::pair<section_edge, int>> left;  // with how often each occurs
  int common = 0;
  for (std::size_t i = 0; i < edges.size();) {
    const std::size_t begin = i;
    int sum = 0;
    for (; i < edges.size() && edges[i][0] == edges[begin][0] && edges[i][1] == edges[begin][1]; ++i)
      sum += edges[i][2] == 0 ? 1 : -1;
    if (sum == 0) continue;
    const auto [a, b, backward] = edges[begin];
    left.push_back({sum > 0 ? section_edge{a, b, 0} : section_edge{b, a, 0}, std::abs(sum)});
    common = std::gcd(common, sum);
  }
  std::vector<section_edge> outline;
  for (const auto& [edge, count] : left) outline.insert(outline.end(), static_cast<std::size_t>(count / common), edge);
  lattice_paths paths;
  std::vector<snapped_point> path;
  for (const auto& cycle : simple_cycles(outline)) {
    path.clear();
    for (const std::uint32_t e : cycle) path.push_back(points[outline[e].from]);
    paths.push_back(path);
  }
  return paths;
}

CONCINO_INLINE plate_shadow find_shadow(const part_surface& part, const shadow_options& options,
                                        const polygon_clipper& back_end) {
  const char* const caller = "shadow_on_plate";
  const build_frame frame(checked_direction(options.direction, caller));
  plate_shadow result;
  result.step_x = frame.x;
  result.step_y = frame.y;
  double lowest = part.points.empty() ? 0 : dot(part.points.front(), frame.up);
  std::vector<slice_point> points;
  planar_box around;
  for (const vec3& p : part.points) {
    lowest = std::min(lowest, dot(p, frame.up));
    const vec3 x = part.to_mesh(p);
    points.push_back({dot(x, frame.x), dot(x, frame.y)});
    around.add(points.back());
  }
  result.origin =
      part.height_to_mesh(plate_height(part, options.plate, frame.up, lowest, part.tolerance, caller), frame.up) *
      frame.up;
  const lattice to(caller, around, 0, 40);
  std::vector<snapped_point> snapped;
  for (const slice_point& p : points) snapped.push_back(to(p));
  const lattice_paths outline = outline_of_triangles(std::move(snapped), part.triangles);
  const std::optional<lattice_regions> done = disjoint_regions(outline);
  static_cast<planar_regions&>(result) =
      regions_from(done ? *done : back_end.combine(region_operation::unite, outline, {}), to);
  return result;
}

}  // namespace concino::detail
