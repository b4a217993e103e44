// The curve of a bone: its length, and its points and radii at any place.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>

#include <cstddef>
#include <vector>

namespace concino {

/// A curve of straight segments with radii.
struct bone_curve {
  std::vector<vec3> points;   // of a cycle, the last one is the first
  std::vector<double> radii;  // of each point; empty if there are none

  /// Whether it ends where it begins.
  bool is_cycle() const { return points.size() > 3 && points.front() == points.back(); }
};

/// A place on a curve.
struct bone_sample {
  vec3 point;
  double radius = 0;        // interpolated; 0 without radii
  vec3 direction;           // along the curve, of length 1; 0 if the curve has no length
  std::size_t segment = 0;  // from points[segment] to the next one
  double parameter = 0;     // along the segment, from 0 to 1
};

/// The length of a curve.
/// Needs:  nothing.      Result: in units of the points; 0 if there are fewer than two.      Cost: O(points).
/// Errors: none.
double length(const bone_curve& curve);

/// The place at a fraction of the length of a curve: sample(bone, 0.5) is its middle.
/// Needs:  a curve with a point at least; a fraction from 0 to 1.
/// Result: point and radius are interpolated along the segment; those of the ends are exact. Scales exactly with powers
///         of 2.
/// Cost:   O(points).
/// Errors: invalid_argument if there are no points, if the radii are not as many, or if the fraction is out of range.
bone_sample sample(const bone_curve& curve, double fraction);

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/skeleton/detail/bone_curve.ipp>
#endif
