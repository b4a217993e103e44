// Watertight intersection of a ray with triangles and boxes: no ray passes between two triangles that share an edge.
#pragma once

#include <concino/geometry/bounding_box.hpp>
#include <concino/geometry/orientation.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace concino::detail {

/// A ray transformed to run along the third axis, from 0. Triangles are sheared accordingly and tested in projection,
/// where the sign of each edge is exact. Points are in units of a tree: of magnitude 1 at most.
/// Source: Woop, Benthin, Wald 2013, "Watertight ray/triangle intersection"; Ize 2013, "Robust BVH ray traversal", for
///         the boxes.
class ray_test {
  vec3 origin_, step_, slope_;  // slope: 1 / step where step is not 0
  std::size_t x_ = 0, y_ = 1, z_ = 2;
  double shear_x_ = 0, shear_y_ = 0, pad_ = 0;

 public:
  struct crossing {
    double parameter = std::numeric_limits<double>::infinity();  // infinite: no crossing
    vec3 point;

    explicit operator bool() const { return parameter < std::numeric_limits<double>::infinity(); }
  };

  /// step: the direction, of magnitude about 1.
  ray_test(const vec3& origin, const vec3& step) : origin_(origin), step_(step) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (std::abs(step[k]) > std::abs(step[z_])) z_ = k;
      slope_[k] = 1 / step[k];
    }
    x_ = (z_ + 1) % 3;
    y_ = (z_ + 2) % 3;
    shear_x_ = step[x_] / step[z_];
    shear_y_ = step[y_] / step[z_];
    // a bound of shearing errors; boxes are widened by more than that, so that no triangle is missed that the test
    // below would hit
    pad_ = 0x1p-48 * (2 + std::max({std::abs(origin.x), std::abs(origin.y), std::abs(origin.z)}));
  }

  /// The parameter at which the ray enters the box, 0 if it starts inside, or infinity. A lower bound of the parameters
  /// of all items in the box.
  double enters(const vec3& low, const vec3& high) const {
    double first = 0, last = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
      const double a = low[k] - pad_ - origin_[k], b = high[k] + pad_ - origin_[k];
      if (step_[k] == 0) {
        if (a > 0 || b < 0) return std::numeric_limits<double>::infinity();
        continue;
      }
      const double p = a * slope_[k], q = b * slope_[k];
      first = std::max(first, std::min(p, q));
      last = std::min(last, std::max(p, q));
    }
    return first * (1 - 0x1p-50) <= last * (1 + 0x1p-50) ? first * (1 - 0x1p-50)
                                                         : std::numeric_limits<double>::infinity();
  }

  /// Where the ray crosses the triangle, boundary included; a triangle seen edge-on is not crossed.
  crossing operator()(const vec3& a, const vec3& b, const vec3& c) const {
    const vec3 p = sheared(a), q = sheared(b), r = sheared(c);
    double u = q.x * r.y - q.y * r.x, v = r.x * p.y - r.y * p.x, w = p.x * q.y - p.y * q.x;
    if (!clear(u, q, r)) u = std::abs(u) * sign(q, r);
    if (!clear(v, r, p)) v = std::abs(v) * sign(r, p);
    if (!clear(w, p, q)) w = std::abs(w) * sign(p, q);
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return {};
    const double whole = u + v + w;
    if (!(std::abs(whole) > 0)) return {};
    u /= whole;
    v /= whole;
    w /= whole;
    double t = (u * p.z + v * q.z + w * r.z) / step_[z_];
    if (t < 0x1p-30) {  // the sign is decided exactly; for an origin on the triangle the parameter is 0
      const int side = orient3d(a, b, c, origin_);
      if (side != 0 && (side > 0) == (whole * step_[z_] > 0)) return {};
      t = side == 0 ? 0 : std::max(t, 0.0);
    }
    return {t, u * a + v * b + w * c};
  }

 private:
  vec3 sheared(const vec3& a) const {
    const vec3 d = a - origin_;
    return {d[x_] - shear_x_ * d[z_], d[y_] - shear_y_ * d[z_], d[z_]};
  }
  static bool clear(double det, const vec3& p, const vec3& q) {
    return std::abs(det) > 0x1p-50 * (std::abs(p.x * q.y) + std::abs(p.y * q.x));
  }
  static double sign(const vec3& p, const vec3& q) { return orient2d(p, q, vec3{}); }
};

}  // namespace concino::detail
