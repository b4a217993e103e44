// Frames up to the 24 rotations of a cube, and the harmonics of degree 4 that stand for them.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace concino {

/// Three perpendicular vectors of length 1, right-handed.
using orthonormal_frame = std::array<vec3, 3>;

namespace detail {

/// The coefficients of a function on the unit sphere in the nine harmonic polynomials of degree 4. The polynomials are
/// scaled so that the product of their values at unit vectors x and y is the Legendre polynomial P4 of x . y.
using quartic = std::array<double, 9>;

inline double dot(const quartic& a, const quartic& b) {
  double sum = 0;
  for (std::size_t i = 0; i < 9; ++i) sum += a[i] * b[i];
  return sum;
}

inline void add(quartic& sum, const quartic& a) {
  for (std::size_t i = 0; i < 9; ++i) sum[i] += a[i];
}

/// The values of the nine polynomials at x.
quartic harmonics_at(const vec3& x);
/// The function of a frame: the degree 4 part of the sum of (x . e)^4 over the three vectors e, scaled to length 1. It
/// is the same for all 24 frames of a cube.
quartic harmonics_of(const orthonormal_frame& f);
/// The part that the functions of all frames with the vector n share.
quartic harmonics_around(const vec3& n);

/// Any frame whose first vector is n, of length 1.
orthonormal_frame some_frame(const vec3& n);

/// The frame whose first vector is n, of length 1, and whose function is nearest to q.
orthonormal_frame closest_aligned_frame(const quartic& q, const vec3& n);

/// Finds the frame whose function is nearest to a given one.
class closest_frame {
  struct candidate {
    orthonormal_frame frame;
    quartic function;
  };
  std::vector<candidate> candidates_;

 public:
  closest_frame();
  /// Starts from the best of some fixed frames and `near`. Then it turns two vectors at a time by the best angle.
  orthonormal_frame operator()(const quartic& q, const orthonormal_frame& near) const;
  /// The frame nearest to the mean of the functions of frames, one or more.
  orthonormal_frame to_mean(std::span<const orthonormal_frame> frames) const;
};

/// The one of the 24 frames of the cube of f that is nearest to `to`.
orthonormal_frame turned_to(const orthonormal_frame& f, const orthonormal_frame& to);

}  // namespace detail

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/directions/detail/frames/octahedral.ipp>
#endif
