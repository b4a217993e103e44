// Defines overhang_search.hpp.
#pragma once

#include <concino/core/parallel.hpp>
#include <concino/geometry/bounding_box.hpp>
#include <concino/print/detail/supports/overhang_search.hpp>
#include <concino/print/detail/supports/support_finder.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace concino::detail {

CONCINO_INLINE void check_limits(const overhang_limits& limits, const char* caller) {
  if (!(limits.max_angle_deg >= 0 && limits.max_angle_deg <= 90))
    core::throw_joined<invalid_argument>({caller, ": options.max_angle_deg must be in [0, 90]"});
  if (!(limits.plate_tolerance >= 0 && limits.plate_tolerance <= 0.1))
    core::throw_joined<invalid_argument>({caller, ": options.plate_tolerance must be in [0, 0.1]"});
}

CONCINO_INLINE overhang_figures find_overhangs(const part_surface& part, const vec3& up, const overhang_limits& limits,
                                               const char* caller) {
  check_limits(limits, caller);
  overhang_figures found;
  if (part.points.empty()) {
    found.plate = plate_height(part, limits.plate, up, 0, 0, caller);
    return found;
  }
  std::vector<double> heights(part.points.size());
  box bounds;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    heights[i] = dot(part.points[i], up);
    bounds.add(part.points[i]);
  }
  const auto [lowest, highest] = std::minmax_element(heights.begin(), heights.end());
  const double near = std::max(limits.plate_tolerance * bounds.diagonal(), part.tolerance);
  found.plate = std::min(*lowest, plate_height(part, limits.plate, up, *lowest, near, caller));
  found.height = *highest - found.plate;

  std::vector<bool> on_plate(part.areas.size(), true);
  for (std::size_t t = 0; t < part.triangles.size(); ++t)
    for (const std::uint32_t v : part.triangles[t])
      if (heights[v] > found.plate + near) on_plate[part.owners[t]] = false;
  constexpr double pi = 3.14159265358979323846;
  const double limit = std::cos((limits.max_angle_deg - 1e-6) * pi / 180);
  for (std::size_t p = 0; p < part.areas.size(); ++p) {
    const double area = norm(part.areas[p]), down = -dot(part.areas[p], up);
    if (!(down > 0)) continue;
    if (on_plate[p]) {
      found.plate_area += area;
    } else if (limits.max_angle_deg > 1e-6 && down > limit * area) {
      found.area += area;
      found.polygons.push_back(static_cast<std::uint32_t>(p));
    }
  }
  return found;
}

CONCINO_INLINE supports_size supports_below(const part_surface& part, const vec3& up, const overhang_figures& found) {
  if (found.polygons.empty()) return {};
  const build_frame frame(up);
  std::vector<vec3> points;
  for (const vec3& x : part.points) points.push_back(frame(x));
  std::vector<bool> overhangs(part.areas.size());
  for (const std::uint32_t p : found.polygons) overhangs[p] = true;
  std::vector<height_triangle> floors, ceilings;
  for (std::size_t t = 0; t < part.triangles.size(); ++t) {
    const auto& v = part.triangles[t];
    height_triangle h;
    const int facing = make_height_triangle({points[v[0]], points[v[1]], points[v[2]]}, part.tolerance, h);
    if (facing > 0) floors.push_back(h);
    else if (facing < 0 && overhangs[part.owners[t]]) ceilings.push_back(h);
  }
  const support_finder finder(std::move(floors), found.plate, part.tolerance);
  std::vector<supports_size> parts(ceilings.size());
  parallel_for(ceilings.size(), [&](std::size_t i) { parts[i] = finder.below(ceilings[i]); }, 32);
  supports_size sum;
  for (const supports_size& s : parts) {
    sum.volume += s.volume;
    sum.contact_area += s.contact_area;
  }
  return sum;
}

}  // namespace concino::detail
