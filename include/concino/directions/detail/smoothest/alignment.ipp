// Bodies of smoothest_values.hpp: directions that are wanted, by the user, along the boundary, along curvature.
#pragma once

#include <concino/directions/detail/smoothest/smoothest_values.hpp>

#include <cmath>
#include <numbers>

namespace concino::detail {

CONCINO_INLINE void wanted_values::pull(std::size_t v, double by, const complex_value& to) {
  if (is_fixed[v] || !(by > 0)) return;
  const double sum = weight[v] + by;
  wanted[v] = (weight[v] / sum) * wanted[v] + (by / sum) * to;
  weight[v] = sum;
}

CONCINO_INLINE void wanted_values::fix(std::size_t v, const complex_value& to, const char* caller) {
  constexpr double rounding = 1e-9;
  if (is_fixed[v] && std::abs(wanted[v] - to) > rounding)
    core::throw_joined<invalid_argument>(
        {caller, ": two directions that contradict are given at vert ", v, "; give one, or make them soft"});
  wanted[v] = to;
  is_fixed[v] = 1;
}

CONCINO_INLINE void fix_at_boundary(const oriented_surface& s, int n, wanted_values& wishes, const char* caller) {
  for (std::size_t v = 0; v < s.num_verts(); ++v) {
    if (!s.on_boundary[v]) continue;
    const std::uint32_t first = s.around[v];
    std::uint32_t last = first;
    while (s.counter_clockwise(last) != oriented_surface::none) last = s.counter_clockwise(last);
    const double out = s.from[first], in = s.from[last] + s.angle[last] - std::numbers::pi;
    complex_value sum = unit_complex(n * out) + unit_complex(n * in);
    constexpr double rounding = 1e-9;
    if (std::abs(sum) < rounding) sum = unit_complex(n * (out + in) / 2);  // both cancel: the mean of the angles
    wishes.fix(v, sum / std::abs(sum), caller);
  }
}

CONCINO_INLINE void pull_to_curvature(const oriented_surface& s, int n, double weight, wanted_values& wishes) {
  std::vector<vec3> normal(s.num_polys());
  for (std::size_t p = 0; p < s.num_polys(); ++p) {
    const vec3 area = s.vector_area(p);
    normal[p] = area / norm(area);
  }
  std::vector<complex_value> sum(s.num_verts());
  for (std::uint32_t c = 0; c < s.vert.size(); ++c) {
    if (s.twin[c] == oriented_surface::none) continue;
    const vec3 &a = normal[s.poly[c]], &b = normal[s.poly[s.twin[c]]];
    const vec3 x = s.points[s.vert[s.next[c]]] - s.points[s.vert[c]];
    if (!(norm(x) > 0)) continue;
    const double bend = std::atan2(dot(cross(a, b), x / norm(x)), dot(a, b));
    sum[s.vert[c]] += (bend * norm(x) / 2) * unit_complex(2 * s.from[c]);
  }
  for (std::size_t v = 0; v < s.num_verts(); ++v) {
    const double size = std::abs(sum[v]);
    constexpr double rounding = 1e-12;
    if (!(size > rounding * std::sqrt(s.mass[v]))) continue;
    complex_value to = 1;
    for (int k = 0; k < n / 2; ++k) to *= sum[v] / size;
    wishes.pull(v, weight * size * size / s.mass[v], to);
  }
}

}  // namespace concino::detail
