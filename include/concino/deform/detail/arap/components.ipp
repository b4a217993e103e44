// Bodies of components.hpp: components of verts joined by edges, and the rigid motions by which handles move them.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/deform/affine_map.hpp>
#include <concino/deform/detail/arap/components.hpp>

#include <algorithm>
#include <cmath>

namespace concino::detail {

CONCINO_INLINE double power_of_two_above(double x) {
  if (!(x > 0)) return 1;
  int exponent = 0;
  std::frexp(x, &exponent);
  return std::ldexp(1.0, std::clamp(exponent, -1000, 1000));
}

CONCINO_INLINE double unit_of(const std::vector<vec3>& points, const std::vector<std::size_t>& used) {
  double size = 0;
  for (const std::size_t v : used) {
    const vec3 d = points[v] - points[used.front()];
    size = std::max({size, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  }
  return power_of_two_above(size);
}

CONCINO_INLINE std::vector<vec3> edge_components::moved(const std::vector<vec3>& rest,
                                                        const std::vector<std::uint32_t>& handles,
                                                        const std::vector<vec3>& position) const {
  std::vector<std::vector<vec3>> from(number), to(number);
  std::vector<vec3> all_from, all_to;
  for (const std::uint32_t v : handles) {
    from[of[v]].push_back(rest[v]), to[of[v]].push_back(position[v]);
    all_from.push_back(rest[v]), all_to.push_back(position[v]);
  }
  std::vector<affine_map> motion(number, best_rigid_motion(all_from, all_to));
  for (std::size_t c = 0; c < number; ++c)
    if (!from[c].empty()) motion[c] = best_rigid_motion(from[c], to[c]);
  std::vector<vec3> x(rest.size());
  for (std::size_t v = 0; v < rest.size(); ++v) x[v] = motion[of[v]](rest[v]);
  return x;
}

CONCINO_INLINE void throw_not_determined(const char* caller, const edge_components& components, std::size_t vert,
                                         const char* why) {
  const auto n = std::count(components.of.begin(), components.of.end(), components.of[vert]);
  core::throw_joined<solver_error>({caller, ": the component of vert ", vert, ", which has ", n, " verts, ", why});
}

}  // namespace concino::detail
