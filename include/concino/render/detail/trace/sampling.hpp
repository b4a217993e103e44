// Quasi-random points and directions, the same on every machine and for any number of threads.
#pragma once

#include <concino/core/hash_bytes.hpp>
#include <concino/core/vec3.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

struct unit_point {
  double x = 0, y = 0;  // in [0, 1)
};

constexpr unit_point random_point(std::uint64_t seed) {
  const std::uint64_t bits = core::scrambled(seed);
  return {static_cast<double>(bits >> 32) * 0x1p-32, static_cast<double>(bits & 0xffffffffu) * 0x1p-32};
}

/// Point i of a low-discrepancy sequence: consecutive points are evenly distributed over the unit square. It is moved
/// by `shift`, modulo 1.
/// Source: R2, Roberts 2018; the shift is that of Cranley and Patterson 1976.
inline unit_point low_discrepancy_point(std::uint64_t i, const unit_point& shift) {
  const double n = static_cast<double>(i);
  const double x = shift.x + n * 0.75487766624669276005, y = shift.y + n * 0.56984029099805326591;
  return {x - std::floor(x), y - std::floor(y)};
}

/// A right-handed orthonormal frame (t, b, n) for a unit vector n.      Source: Duff et al. 2017, JCGT 6(1).
struct frame {
  vec3 t, b, n;
  explicit frame(const vec3& normal) : n(normal) {
    const double s = std::copysign(1.0, n.z), a = -1 / (s + n.z), c = n.x * n.y * a;
    t = {1 + s * n.x * n.x * a, s * c, -s * n.x};
    b = {c, s + n.y * n.y * a, -n.y};
  }
  vec3 to_world(double x, double y, double z) const { return t * x + b * y + n * z; }
};

/// A direction in the hemisphere of f.n, with density cosine / pi (Malley's method: a disk projected up to the sphere).
inline vec3 cosine_direction(const frame& f, const unit_point& u) {
  const double r = std::sqrt(u.x), angle = 6.28318530717958647693 * u.y;
  return f.to_world(r * std::cos(angle), r * std::sin(angle), std::sqrt(std::fmax(0.0, 1 - u.x)));
}

/// The cosine_direction for the points of the sequence, moved by a shift. Sines and cosines are computed once, as there
/// are millions of rays.
class cosine_directions {
  struct ray {
    double x, cosine, sine;
  };
  std::vector<ray> rays_;

 public:
  explicit cosine_directions(std::size_t n) : rays_(n) {
    for (std::size_t i = 0; i < n; ++i) {
      const unit_point u = low_discrepancy_point(i, {});
      rays_[i] = {u.x, std::cos(6.28318530717958647693 * u.y), std::sin(6.28318530717958647693 * u.y)};
    }
  }
  std::size_t size() const { return rays_.size(); }

  /// The shift of the sequence for one point of the picture.
  struct turn {
    double x, cosine, sine;
    explicit turn(const unit_point& shift)
        : x(shift.x), cosine(std::cos(6.28318530717958647693 * shift.y)),
          sine(std::sin(6.28318530717958647693 * shift.y)) {}
  };
  vec3 operator()(std::size_t i, const turn& by, const frame& f) const {
    const ray& d = rays_[i];
    const double moved = d.x + by.x, x = moved < 1 ? moved : moved - 1, r = std::sqrt(x);
    return f.to_world(r * (d.cosine * by.cosine - d.sine * by.sine), r * (d.cosine * by.sine + d.sine * by.cosine),
                      std::sqrt(1 - x));
  }
};

/// A direction within the cone about f.n whose half-angle has this cosine, uniform by solid angle.
inline vec3 cone_direction(const frame& f, double cosine, const unit_point& u) {
  const double z = 1 - u.x * (1 - cosine), r = std::sqrt(std::fmax(0.0, 1 - z * z)),
               angle = 6.28318530717958647693 * u.y;
  return f.to_world(r * std::cos(angle), r * std::sin(angle), z);
}

/// The offset of a tent filter two pixels wide, for u in [0, 1).
inline double tent(double u) { return u < 0.5 ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 - 2 * u); }

}  // namespace concino::detail
