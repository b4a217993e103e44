// Sums of squared distances to planes.
#pragma once

#include <concino/core/vec3.hpp>

#include <algorithm>

namespace concino::detail {

/// x -> x'Ax + 2b'x + c, the weighted sum of squared distances of x to planes.
struct quadric {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
  vec3 b;
  double c = 0;

  quadric() = default;
  /// The plane through `at` with unit normal n.
  quadric(const vec3& n, const vec3& at, double weight)
      : xx(weight * n.x * n.x), xy(weight * n.x * n.y), xz(weight * n.x * n.z), yy(weight * n.y * n.y),
        yz(weight * n.y * n.z), zz(weight * n.z * n.z) {
    const double d = -dot(n, at);
    b = weight * d * n;
    c = weight * d * d;
  }

  quadric& operator+=(const quadric& q) {
    xx += q.xx, xy += q.xy, xz += q.xz, yy += q.yy, yz += q.yz, zz += q.zz;
    b += q.b;
    c += q.c;
    return *this;
  }

  /// The sum of the weights, as normals have length 1.
  double trace() const { return xx + yy + zz; }
  vec3 times(const vec3& x) const {
    return {xx * x.x + xy * x.y + xz * x.z, xy * x.x + yy * x.y + yz * x.z, xz * x.x + yz * x.y + zz * x.z};
  }
  double operator()(const vec3& x) const { return std::max(dot(x, times(x)) + 2 * dot(b, x) + c, 0.0); }

  /// The point where the quadric is least; along directions in which it hardly changes, the one nearest to `start`.
  /// Source: Trettner and Kobbelt 2020, "Fast and robust QEF minimization using probabilistic quadrics", for the term
  ///         on the diagonal. Repeated, it has no effect
  /// where the quadric is sharp.
  vec3 min_near(const vec3& start) const {
    const double diagonal = 1e-3 * trace();
    if (!(diagonal > 0)) return start;
    // the factor LDL' of A + diagonal I
    const double d0 = xx + diagonal, l10 = xy / d0, l20 = xz / d0;
    const double d1 = yy + diagonal - l10 * xy, u21 = yz - l10 * xz, l21 = u21 / d1;
    const double d2 = zz + diagonal - l20 * xz - l21 * u21;
    vec3 x = start;
    for (int round = 0; round < 4; ++round) {
      const vec3 r = -times(x) - b;
      const double y1 = r.y - l10 * r.x, z = (r.z - l20 * r.x - l21 * y1) / d2, y = y1 / d1 - l21 * z;
      x += vec3{r.x / d0 - l10 * y - l20 * z, y, z};
    }
    return is_finite(x) ? x : start;
  }
};

}  // namespace concino::detail
