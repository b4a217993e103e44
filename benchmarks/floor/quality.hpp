// The floors of quality: a metric of triangles, tets or hexes from flat arrays, by loops for this metric and this shape alone.
#pragma once

#include "normals.hpp"

#include <algorithm>
#include <cmath>

namespace bench::floors {

inline double determinant(vector3 a, vector3 b, vector3 c) { return dot(a, cross(b, c)); }

/// One value per poly. f(v) is the value of the poly with these verts.
template<u32 Size, class F>
buffer<double> quality_of_each(const buffer<u32>& p2v, const F& f) {
  const u32 n = static_cast<u32>(p2v.size() / Size);
  buffer<double> q(n);
  for (u32 p = 0; p < n; ++p) q[p] = f(p2v.data() + p * Size);
  return q;
}

struct scaled_jacobian {
  const buffer<double>& points;

  double triangle(const u32* v) const {
    const vector3 a = at(points, v[0]), b = at(points, v[1]), c = at(points, v[2]), u = b - a, w = c - a, x = c - b;
    const double lu = norm(u), lw = norm(w), lx = norm(x);
    return 2 / std::sqrt(3.0) * norm(cross(u, w)) / std::max({lu * lw, lu * lx, lw * lx});
  }
  double tet(const u32* v) const {
    const vector3 a = at(points, v[0]), b = at(points, v[1]), c = at(points, v[2]), d = at(points, v[3]);
    const vector3 ab = b - a, ac = c - a, ad = d - a, bc = c - b, bd = d - b, cd = d - c;
    const double l[] = {norm(ab), norm(ac), norm(ad), norm(bc), norm(bd), norm(cd)};
    return std::sqrt(2.0) * determinant(ab, ac, ad) / std::max({l[0] * l[1] * l[2], l[0] * l[3] * l[4], l[1] * l[3] * l[5], l[2] * l[4] * l[5]});
  }
  double hex(const u32* v) const {
    static constexpr u32 corners[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
    vector3 x[8], axes[3] = {};
    for (u32 i = 0; i < 8; ++i) x[i] = at(points, v[i]);
    double q = 1;
    for (u32 i = 0; i < 8; ++i) {
      const vector3 e[] = {x[corners[i][0]] - x[i], x[corners[i][1]] - x[i], x[corners[i][2]] - x[i]};
      q = std::min(q, determinant(e[0], e[1], e[2]) / (norm(e[0]) * norm(e[1]) * norm(e[2])));
    }
    static constexpr u32 edges[3][4][2] = {{{0, 1}, {3, 2}, {4, 5}, {7, 6}}, {{0, 3}, {1, 2}, {4, 7}, {5, 6}}, {{0, 4}, {1, 5}, {2, 6}, {3, 7}}};
    for (u32 k = 0; k < 3; ++k)
      for (const auto& e : edges[k]) axes[k] = axes[k] + (x[e[1]] - x[e[0]]);
    return std::min(q, determinant(axes[0], axes[1], axes[2]) / (norm(axes[0]) * norm(axes[1]) * norm(axes[2])));
  }
};

struct mean_ratio {
  const buffer<double>& points;

  double triangle(const u32* v) const {
    const vector3 a = at(points, v[0]), u = at(points, v[1]) - a, w = at(points, v[2]) - a, x = w - u;
    return 2 * std::sqrt(3.0) * norm(cross(u, w)) / (dot(u, u) + dot(w, w) + dot(x, x));
  }
  double tet(const u32* v) const {
    const vector3 a = at(points, v[0]), u = at(points, v[1]) - a, w = at(points, v[2]) - a, x = at(points, v[3]) - a, uw = w - u, wx = x - w, xu = u - x;
    const double root = std::cbrt(determinant(u, w, x) / 2);
    return (root < 0 ? -12 : 12) * root * root / (dot(u, u) + dot(w, w) + dot(x, x) + dot(uw, uw) + dot(wx, wx) + dot(xu, xu));
  }
};

}  // namespace bench::floors
