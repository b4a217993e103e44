// The rotation nearest to a matrix.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>

#include <array>
#include <limits>

namespace concino::detail {

/// A sum of products of vectors: column k of `of` is the sum of a[k] * b.
struct moment_matrix {
  std::array<vec3, 3> of{};

  void add(double weight, const vec3& a, const vec3& b) {
    of[0] += (weight * a.x) * b;
    of[1] += (weight * a.y) * b;
    of[2] += (weight * a.z) * b;
  }
};

/// The images of the unit vectors under a rotation, or a sum of such.
using rotation_columns = std::array<vec3, 3>;
inline vec3 turned(const rotation_columns& r, const vec3& a) { return a.x * r[0] + a.y * r[1] + a.z * r[2]; }

/// The rotation R for which the sum of R a . b is largest. If several are, the one with the smallest angle. bound: not
/// below that sum; the nearer, the quicker.
rotation_columns best_rotation(const moment_matrix& moments, double bound = std::numeric_limits<double>::infinity());

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/deform/detail/skin/best_rotation.ipp>
#endif
