// Bodies of surface_exits.hpp: where a line along a field leads on from a point of a surface: into a triangle around
// it, or along an edge.
#pragma once

#include <concino/core/small_array.hpp>
#include <concino/lines/detail/cells/line_signs.hpp>
#include <concino/lines/detail/cells/surface_exits.hpp>

#include <algorithm>
#include <cmath>

namespace concino::detail {

CONCINO_INLINE double sliding_speed(double speed1, double along1, double speed2, double along2) {
  const double exit_speed = speed1 + speed2;
  return exit_speed > 0 ? (speed2 * along1 + speed1 * along2) / exit_speed : (along1 + along2) / 2;
}

CONCINO_INLINE double speed_in_plane(const vec3& field, const vec3& normal) {
  const double n = norm(normal);
  return n > 0 ? norm(cross(field, normal)) / n : 0;
}

/// A side from the point to `to`, as one of its triangles sees it.
struct incident_side {
  std::size_t key = 0, sector = 0;
  vec3 to;
  int inward = 0;  // the sign of the field's part into the triangle
  double exit_speed = 0, along = 0;
  bool is_a = false;
};

CONCINO_INLINE surface_exit steepest_exit(const vec3& from, std::span<const surface_sector> sectors) {
  core::small_array<incident_side, 32> sides;
  surface_exit best;
  double best_speed = 0;
  vec3 best_target;
  const auto keep_if_faster = [&](surface_exit::kind to, std::size_t sector, double speed, const vec3& target) {
    if (best.to != surface_exit::kind::none &&
        (speed < best_speed || (speed == best_speed && !lies_before(target, best_target))))
      return;
    best = {to, sector};
    best_speed = speed;
    best_target = target;
  };
  for (std::size_t i = 0; i < sectors.size(); ++i) {
    const surface_sector& s = sectors[i];
    const signed_value a = side_in_plane(s.field, s.a, s.normal, from), b = side_in_plane(s.field, s.b, s.normal, from);
    if (a.sign < 0 && b.sign > 0) {  // a to the right, b to the left
      keep_if_faster(surface_exit::kind::sector, i, speed_in_plane(s.field, s.normal),
                     (a.value * s.b - b.value * s.a) / (a.value - b.value));
    }
    const double n = norm(s.normal), to_a = distance(s.a, from), to_b = distance(s.b, from);
    if (!(n > 0) || !(to_a > 0) || !(to_b > 0)) continue;
    sides.push_back(
        {s.side_a, i, s.a, -a.sign, std::max(0.0, a.value / (n * to_a)), dot(s.field, s.a - from) / to_a, true});
    sides.push_back(
        {s.side_b, i, s.b, b.sign, std::max(0.0, -b.value / (n * to_b)), dot(s.field, s.b - from) / to_b, false});
  }
  std::sort(sides.begin(), sides.end(), [](const incident_side& x, const incident_side& y) {
    return x.key != y.key ? x.key < y.key : lies_before(y.to, x.to);
  });
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t last = i + 1;
    while (last < sides.size() && sides[last].key == sides[i].key) ++last;
    const incident_side &one = sides[i], &two = sides[last - 1];
    const std::size_t n = last - i;
    i = last;
    const auto keep_side_if_faster = [&](const incident_side& x, double speed) {
      if (speed > 0)
        keep_if_faster(x.is_a ? surface_exit::kind::side_a : surface_exit::kind::side_b, x.sector, speed, x.to);
    };
    if (n == 2 && one.inward <= 0 && two.inward <= 0) {
      const bool first = one.exit_speed != two.exit_speed ? one.exit_speed > two.exit_speed : one.sector < two.sector;
      keep_side_if_faster(first ? one : two, sliding_speed(one.exit_speed, one.along, two.exit_speed, two.along));
    } else if (n <= 2) {  // a field exactly along a side leads along it, also at the boundary
      if (one.inward == 0) keep_side_if_faster(one, one.along);
      if (n == 2 && two.inward == 0) keep_side_if_faster(two, two.along);
    }
  }
  return best;
}

}  // namespace concino::detail
