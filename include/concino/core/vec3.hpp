// vec3: points and vectors in space.
#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#include <type_traits>

namespace concino {

namespace detail {
template<class T> concept number = std::integral<T> || std::floating_point<T>;
}

/// Three doubles, constructible from any three numbers, so that `{i, 0, 1.5}` with an int i is not a narrowing
/// conversion.
struct vec3 {
  double x = 0, y = 0, z = 0;

  constexpr vec3() = default;
  template<detail::number X, detail::number Y, detail::number Z>
  constexpr vec3(X x_, Y y_, Z z_)
      : x(static_cast<double>(x_)), y(static_cast<double>(y_)), z(static_cast<double>(z_)) {}

  constexpr double& operator[](std::size_t i) { return i == 0 ? x : i == 1 ? y : z; }
  constexpr double operator[](std::size_t i) const { return i == 0 ? x : i == 1 ? y : z; }

  constexpr vec3& operator+=(const vec3& o) { x += o.x; y += o.y; z += o.z; return *this; }
  constexpr vec3& operator-=(const vec3& o) { x -= o.x; y -= o.y; z -= o.z; return *this; }
  constexpr vec3& operator*=(double s) { x *= s; y *= s; z *= s; return *this; }
  constexpr vec3& operator/=(double s) { x /= s; y /= s; z /= s; return *this; }

  friend constexpr vec3 operator+(vec3 a, const vec3& b) { return a += b; }
  friend constexpr vec3 operator-(vec3 a, const vec3& b) { return a -= b; }
  friend constexpr vec3 operator-(const vec3& a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr vec3 operator*(vec3 a, double s) { return a *= s; }
  friend constexpr vec3 operator*(double s, vec3 a) { return a *= s; }
  friend constexpr vec3 operator/(vec3 a, double s) { return a /= s; }
  friend constexpr bool operator==(const vec3&, const vec3&) = default;
};

static_assert(sizeof(vec3) == 24 && std::is_trivially_copyable_v<vec3>);

/// Scalar product, vector product, length, distance, and whether all parts are finite.
/// Needs:  any vectors.      Result: in the units of the vectors, products in their squares.      Cost: O(1).
/// Errors: none; infinite parts and parts that are not numbers are used as they are.
constexpr double dot(const vec3& a, const vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr vec3 cross(const vec3& a, const vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// Length without intermediate overflow or underflow: squares are used if they keep all digits, which is nearly always.
inline double norm(const vec3& a) {
  const double squared = dot(a, a);
  if (squared > 1e-280 && squared < 1e290) return std::sqrt(squared);
  return std::hypot(std::hypot(a.x, a.y), a.z);  // the form of three arguments is not a number for infinite ones
                                                 // (libstdc++ 12)
}
inline double distance(const vec3& a, const vec3& b) { return norm(a - b); }
inline bool is_finite(const vec3& a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

/// Any point as a vec3.
/// Needs:  p[0], p[1], p[2] that convert to double.      Result: the same coordinates.      Cost: O(1).      Errors:
///         none.
template<class P>
constexpr vec3 to_vec3(const P& p) {
  if constexpr (std::same_as<P, vec3>) return {p.x, p.y, p.z};  // part by part stays in registers; g++ copies a whole
                                                                // vec3 through memory
  else return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

}  // namespace concino
