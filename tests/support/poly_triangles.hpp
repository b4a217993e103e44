// Brute-force reference for trees over polys: the triangles of every poly, and queries that test each of them.
#pragma once

#include <concino/geometry/polygon.hpp>
#include <concino/geometry/triangulate_polygon.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace concino::testing {

using corners3 = std::array<vec3, 3>;

/// The triangles of a polygon, or of the boundary of a polyhedron, counter-clockwise as seen from outside. Faces of more than three verts are split
/// at their means.
template<class M>
std::vector<corners3> triangles_of(const M& m, const poly_t<M>& p) {
  std::vector<corners3> r;
  std::vector<vec3> x;
  if constexpr (SurfaceMesh<M>) {
    for (const vert_t<M> v : adj_p2v(m, p)) x.push_back(to_vec3(point(m, v)));
    for (const auto& t : triangulate_polygon(x)) r.push_back({x[t[0]], x[t[1]], x[t[2]]});
  } else {
    for (const face_t<M> f : adj_p2f(m, p)) {
      x.clear();
      for (const vert_t<M> v : adj_f2v(m, f)) x.push_back(to_vec3(point(m, v)));
      const vec3 mean = shape_of(m, adj_f2v(m, f)).mean;
      if (!face_is_outward(m, p, f)) std::reverse(x.begin(), x.end());
      if (x.size() == 3) r.push_back({x[0], x[1], x[2]});
      else
        for (std::size_t i = 0; i < x.size(); ++i) r.push_back({x[i], x[(i + 1) % x.size()], mean});
    }
  }
  return r;
}

/// The winding number of the triangles around x, by their solid angles.   Source: van Oosterom and Strackee 1983.
inline double times_round(const std::vector<corners3>& triangles, const vec3& x) {
  double sum = 0;
  for (const auto& t : triangles) {
    const vec3 a = t[0] - x, b = t[1] - x, c = t[2] - x;
    const double u = norm(a), v = norm(b), w = norm(c);
    sum += 2 * std::atan2(dot(a, cross(b, c)), u * v * w + dot(a, b) * w + dot(b, c) * u + dot(c, a) * v);
  }
  return sum / (4 * 3.14159265358979323846);
}

/// The distance to a triangle: to its plane, or to its edges if the foot of the perpendicular is outside.
inline double distance_to(const corners3& t, const vec3& x) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const vec3 &a = t[i], d = t[(i + 1) % 3] - a;
    least = std::min(least, norm(x - (a + std::clamp(dot(x - a, d) / dot(d, d), 0.0, 1.0) * d)));
  }
  vec3 n = cross(t[1] - t[0], t[2] - t[0]);
  n /= norm(n);
  for (std::size_t i = 0; i < 3; ++i)
    if (dot(cross(t[(i + 1) % 3] - t[i], x - t[i]), n) < 0) return least;
  return std::min(least, std::abs(dot(x - t[0], n)));
}

/// The parameter at which a ray meets a triangle, or infinity.   Source: Moller and Trumbore 1997.
inline double met_at(const corners3& t, const vec3& origin, const vec3& direction) {
  const vec3 e = t[1] - t[0], f = t[2] - t[0], p = cross(direction, f), s = origin - t[0], q = cross(s, e);
  const double det = dot(e, p), u = dot(s, p) / det, v = dot(direction, q) / det, at = dot(f, q) / det;
  return u >= 0 && v >= 0 && u + v <= 1 && at >= 0 ? at : std::numeric_limits<double>::infinity();
}

/// Whether the triangle meets the box [low, high], by clipping it.   Source: Sutherland and Hodgman 1974.
inline bool reaches_into(const corners3& t, const vec3& low, const vec3& high) {
  std::vector<vec3> rest(t.begin(), t.end()), kept;
  for (std::size_t k = 0; k < 3; ++k)
    for (const double sign : {1.0, -1.0}) {
      const auto inside = [&](const vec3& x) { return sign > 0 ? x[k] - low[k] : high[k] - x[k]; };
      kept.clear();
      for (std::size_t i = 0; i < rest.size(); ++i) {
        const vec3 &a = rest[i], &b = rest[(i + 1) % rest.size()];
        if (inside(a) >= 0) kept.push_back(a);
        if ((inside(a) >= 0) != (inside(b) >= 0)) kept.push_back(a + inside(a) / (inside(a) - inside(b)) * (b - a));
      }
      rest = kept;
    }
  return !rest.empty();
}

/// Random points of a cube, the same on every machine.
class point_stream {
  std::mt19937 random_;
  double low_, high_;

  double next() { return low_ + (high_ - low_) * (static_cast<double>(random_()) / 4294967296.0); }

 public:
  point_stream(unsigned seed, double low, double high) : random_(seed), low_(low), high_(high) {}
  vec3 operator()() {
    const double x = next(), y = next(), z = next();
    return {x, y, z};
  }
};

}  // namespace concino::testing
