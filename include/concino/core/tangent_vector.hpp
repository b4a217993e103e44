// Vectors that are tangent to a surface, as two numbers.
#pragma once

#include <concino/core/vec3.hpp>

#include <cmath>

namespace concino {

/// A vector in the tangent plane of a vert, an edge or a poly of a surface.
///
/// At a vert, angles are measured along the surface. Angle 0 is along the first edge of adj_v2e. Angles increase
/// counter-clockwise, as the first poly at the vert in the order of polys(m) is seen. At a vert inside the surface they
/// are multiplied by 2 pi over the sum of the angles of the polys, so that a full turn is 2 pi. At the boundary they
/// are those of the surface. On an edge, x is along it, from the first vert of adj_e2v to the second, and y is
/// perpendicular, into the first poly of adj_e2p. In a poly, x is along its first edge, from the first vert of adj_p2v
/// to the second, and y is perpendicular, in the plane of its vector area, to the left. So the numbers depend on which
/// edge, poly or corner is stored first. Lengths of vectors and angles between vectors of one element do not.
struct tangent_vector {
  double x = 0, y = 0;

  constexpr tangent_vector() = default;
  template<detail::number X, detail::number Y>
  constexpr tangent_vector(X x_, Y y_) : x(static_cast<double>(x_)), y(static_cast<double>(y_)) {}

  friend constexpr tangent_vector operator+(const tangent_vector& a, const tangent_vector& b) {
    return {a.x + b.x, a.y + b.y};
  }
  friend constexpr tangent_vector operator-(const tangent_vector& a, const tangent_vector& b) {
    return {a.x - b.x, a.y - b.y};
  }
  friend constexpr tangent_vector operator*(double s, const tangent_vector& a) { return {s * a.x, s * a.y}; }
  friend constexpr bool operator==(const tangent_vector&, const tangent_vector&) = default;
};

/// The scalar product, the length and the angle from the x-axis, in (-pi, pi].
/// Needs:  any vectors.      Result: as said; the angle of 0 is 0.      Cost: O(1).      Errors: none.
constexpr double dot(const tangent_vector& a, const tangent_vector& b) { return a.x * b.x + a.y * b.y; }
inline double norm(const tangent_vector& a) {
  const double squared = dot(a, a);
  // squares are used where they keep all digits
  return squared > 1e-280 && squared < 1e290 ? std::sqrt(squared) : std::hypot(a.x, a.y);
}
inline double angle(const tangent_vector& a) { return std::atan2(a.y, a.x); }

}  // namespace concino
