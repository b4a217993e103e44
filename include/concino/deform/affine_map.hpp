// Affine maps of space: rotations, translations and what is composed of them.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace concino {

/// A map of points: f(p) is a point. The default is the identity.
struct affine_map {
  vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};  // the images of the three unit vectors
  vec3 origin;                              // the image of the origin

  vec3 operator()(const vec3& p) const { return p.x * x + p.y * y + p.z * z + origin; }
  /// The image of a vector, without the translation.
  vec3 turn(const vec3& v) const { return v.x * x + v.y * y + v.z * z; }
  /// (f * g)(p) = f(g(p)).
  friend affine_map operator*(const affine_map& f, const affine_map& g) {
    return {f.turn(g.x), f.turn(g.y), f.turn(g.z), f(g.origin)};
  }
  friend bool operator==(const affine_map&, const affine_map&) = default;
};

/// The translation by v; the rotation by an angle about the line through on_axis.
/// Needs:  finite numbers; angle in radians, counter-clockwise seen from the end of axis; axis of any length.
/// Result: a map.      Cost: O(1).
/// Errors: invalid_argument if a number is not finite, or the axis has no length.
affine_map translation(const vec3& v);
affine_map rotation(const vec3& on_axis, const vec3& axis, double angle);

/// Whether a map keeps lengths and orientation: a rotation and a translation.
/// Needs:  tolerance of scalar products of the images of unit vectors.      Result: false too if a number is not
///         finite.
/// Cost:   O(1).      Errors: none.
bool is_rigid(const affine_map& f, double tolerance = 1e-9);

/// The rigid motion that brings points nearest to others: the least sum of squared distances.
/// Needs:  as many points in `to` as in `from`, finite.
/// Result: a rotation and a translation. Of several, as for points on a line, the rotation is by the smallest angle;
///         the identity if there are no points.
/// Cost:   O(points).
/// Errors: invalid_argument if the numbers differ, or a coordinate is not finite.
/// Source: Kabsch 1976, "A solution for the best rotation to relate two sets of vectors".
affine_map best_rigid_motion(const std::vector<vec3>& from, const std::vector<vec3>& to);

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/deform/detail/skin/affine_map.ipp>
#endif
