// A brute-force ray tracer, which tests every ray against every triangle: the reference for other ray tracers.
#pragma once

#include <concino/render/ray_caster.hpp>

#include <cmath>

namespace concino::testing {

struct brute_force {
  struct caster {
    triangle_soup soup;

    ray_hit intersect(const vec3& origin, const vec3& direction, double t_near, double t_far) const {
      ray_hit best;
      for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        const auto& t = soup.triangles[i];
        const vec3 a = to_vec3(soup.points[t[0]]), e = to_vec3(soup.points[t[1]]) - a, f = to_vec3(soup.points[t[2]]) - a;
        const vec3 p = cross(direction, f);
        const double det = dot(e, p);
        if (det == 0) continue;
        const vec3 s = origin - a, q = cross(s, e);
        const double u = dot(s, p) / det, v = dot(direction, q) / det, at = dot(f, q) / det;
        if (u < 0 || v < 0 || u + v > 1 || at < t_near || at > t_far || (best && at >= best.t)) continue;
        best = {static_cast<std::uint32_t>(i), u, v, at};
      }
      return best;
    }
    bool occluded(const vec3& origin, const vec3& direction, double t_near, double t_far) const {
      return static_cast<bool>(intersect(origin, direction, t_near, t_far));
    }
  };
  caster build(const triangle_soup& soup) const { return {soup}; }
};

static_assert(RayCaster<brute_force::caster> && RayTracer<brute_force>);

}  // namespace concino::testing
