// Errors of heat geodesics against known distances.
#pragma once

#include <concino/core/vec3.hpp>

#include <support/geodesic_meshes.hpp>
#include <support/kinds.hpp>

#include <algorithm>
#include <cmath>

namespace concino::testing {

struct deviation {
  double mean = 0, largest = 0, farthest = 0, mean_distance = 0;
};

template<class Map, class F>
deviation error_of(const Map& d, const F& exact) {
  deviation e;
  const auto& m = d.mesh();
  for (const auto v : verts(m)) {
    const double x = exact(to_vec3(point(m, v))), wrong = std::abs(d[v] - x), share = 1 / static_cast<double>(num_verts(m));
    e.mean += wrong * share;
    e.mean_distance += x * share;
    e.largest = std::max(e.largest, wrong);
    e.farthest = std::max(e.farthest, x);
  }
  return e;
}

template<class M>
vert_id nearest(const M& m, const vec3& x) {
  vert_id best{0};
  for (const auto v : verts(m))
    if (distance(point(m, v), x) < distance(point(m, best), x)) best = v;
  return best;
}

template<class Heat>
double error_from(const Heat& heat, vert_id s) {
  const vec3 from = point(heat.mesh(), s);
  const deviation e = error_of(heat.distance_from(s), [&](const vec3& x) { return distance(x, from); });
  return e.mean / e.farthest;
}

template<class M>
M square_or_cube(unsigned n) {
  return M(jittered(grid_arrays<M>(n), 0.1 / n, VolumeMesh<M>));
}

}  // namespace concino::testing
