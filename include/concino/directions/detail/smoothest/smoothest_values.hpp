// The smoothest values of an n-direction field: an eigenproblem, or a linear system where directions are wanted.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/progress.hpp>
#include <concino/directions/detail/smoothest/connection_energy.hpp>

#include <complex>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Values that are wanted, by vert: the energy grows by weight |z - wanted|^2, and fixed verts have the value wanted.
struct wanted_values {
  std::vector<complex_value> wanted;
  std::vector<double> weight;
  std::vector<unsigned char> is_fixed;

  explicit wanted_values(std::size_t num_verts)
      : wanted(num_verts), weight(num_verts, 0.0), is_fixed(num_verts, 0) {}

  /// Adds a wish to those of vert v.
  void pull(std::size_t v, double by, const complex_value& to);
  /// Errors: invalid_argument if the vert is fixed to another value.
  void fix(std::size_t v, const complex_value& to, const char* caller);
};

/// Wishes of all verts with edges at the boundary: along it.
void fix_at_boundary(const oriented_surface& s, int n, wanted_values& wishes, const char* caller);

/// Wishes along the direction of the smaller principal curvature, or across, weighted by the difference of both
/// curvatures.      Needs: n even.
void pull_to_curvature(const oriented_surface& s, int n, double weight, wanted_values& wishes);

struct smoothest_values {
  std::vector<complex_value> value;  // by vert
  std::vector<double> energy;        // by component: over the integral of the square, in units of the points
  double residual = 0;               // of the eigenproblems, the largest, over the size of small eigenvalues
};

/// Component by component.      Errors: those of ldlt; cancelled.
smoothest_values find_smoothest(const oriented_surface& s, const connection_energy& e, int n,
                                const wanted_values& wishes, const progress& on_progress);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/directions/detail/smoothest/alignment.ipp>
#include <concino/directions/detail/smoothest/smoothest_values.ipp>
#endif
