// The least dihedral angle of a tet as a number that is quick to compute and to compare.
#pragma once

#include <concino/core/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace concino::detail {

/// The unit normals of the faces opposite to the verts, which point outwards if the tet is positive, and what follows
/// from them.
struct tet_faces {
  static constexpr unsigned pairs[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

  vec3 normal[4];
  double length[4];  // twice the areas
  bool is_positive;

  tet_faces(const vec3& a, const vec3& b, const vec3& c, const vec3& d) {
    const vec3 u = b - a, v = c - a, w = d - a;
    normal[1] = cross(w, v), normal[2] = cross(u, w), normal[3] = cross(v, u);
    normal[0] = -1.0 * (normal[1] + normal[2] + normal[3]);
    is_positive = dot(u, normal[1]) < 0;
    for (unsigned i = 0; i < 4; ++i) {
      length[i] = norm(normal[i]);
      if (length[i] > 0) normal[i] = normal[i] / length[i];
    }
  }

  /// Minus the cosine of the dihedral angle between faces i and j; -1 if one has no area.
  double between(unsigned i, unsigned j) const {
    return length[i] > 0 && length[j] > 0 ? std::clamp(dot(normal[i], normal[j]), -1.0, 1.0) : -1;
  }
  /// The quality of a tet with this value of `between`, which depends on its orientation.
  double signed_quality(double value) const { return is_positive ? value : -2 - value; }
  double quality() const {
    double least = 1;
    for (const auto& x : pairs) least = std::min(least, between(x[0], x[1]));
    return signed_quality(least);
  }
};

/// Minus the cosine of the least dihedral angle: at most 1/3, that of a regular tet. It grows with the angle. Inverted
/// tets have values below -1, as if their angles were negative; NaN never comes out of finite points.
inline double tet_quality(const vec3& a, const vec3& b, const vec3& c, const vec3& d) {
  return tet_faces(a, b, c, d).quality();
}

inline double quality_of_angle(double degrees) { return -std::cos(degrees * std::numbers::pi / 180); }
inline double angle_of_quality(double q) {
  const double degrees = std::acos(std::clamp(q < -1 ? q + 2 : -q, -1.0, 1.0)) * 180 / std::numbers::pi;
  return q < -1 ? -degrees : degrees;
}

/// Whether a change is worth being made: enough better that there is an end to improvements.
inline bool is_better(double now, double before) {
  return before < -1 ? now > before + 1e-6 : now + 1 > 1.001 * (before + 1) + 1e-12;
}

}  // namespace concino::detail
