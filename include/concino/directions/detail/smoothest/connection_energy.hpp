// The energy of an n-direction field: how much it turns over a surface, as a quadratic form of its complex values.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/directions/detail/surface/oriented_surface.hpp>

#include <complex>
#include <cstdint>
#include <vector>

namespace concino::detail {

using complex_value = std::complex<double>;

/// exp(i x)
inline complex_value unit_complex(double x) { return {std::cos(x), std::sin(x)}; }

/// A Hermitian form: the sum of conj(z_i) value z_j over entries, plus its conjugate where i differs from j.
/// Places may be repeated.
struct connection_energy {
  struct entry {
    std::uint32_t i, j;  // verts, j <= i
    complex_value value;
  };
  std::vector<entry> entries;
  std::vector<double> diagonal;  // by vert
};

/// The form of fields of symmetry n. Each poly is laid into its plane, where values of its corners are turned so that
/// the bisectors of their angles there and in the frames agree; then it has the energy of a function by virtual
/// elements. On triangles these are cotangent weights. The form is never negative, whatever the polys are.
connection_energy make_connection_energy(const oriented_surface& s, int n);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/directions/detail/smoothest/connection_energy.ipp>
#endif
