// Stripes at even distances across a field of vectors or lines: angles at the corners of polys.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/progress.hpp>
#include <concino/directions/detail/surface/oriented_surface.hpp>

#include <complex>
#include <vector>

namespace concino::detail {

struct stripe_angles {
  std::vector<double> angle;               // by corner; in the directions that agree with that of the poly's first
  std::vector<int> index;                  // by poly: how many stripes begin in it
  std::vector<unsigned char> field_turns;  // by poly: whether the lines of the field do not agree around it
  double energy = 0;    // of the components, the largest: over the integral of the square, in units of the points
  double residual = 0;  // of the eigenvectors, over the size of small eigenvalues, the largest
};

/// field: n-th powers of the directions by vert, n = 1 or 2. frequency: stripes per unit of the points.
/// Errors: invalid_argument if more than 1,000 stripes would cross an edge; those of ldlt; cancelled.
stripe_angles find_stripes(const oriented_surface& s, int n, const std::vector<std::complex<double>>& field,
                           double frequency, const progress& on_progress);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/directions/detail/stripes/stripe_angles.ipp>
#endif
