// The indices of a field of directions: how often it turns about polys and along loops of the boundary.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/directions/detail/surface/oriented_surface.hpp>

#include <complex>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// The angle, at most pi, by which the n-th powers of directions turn along the edge of corner c.
double turn_along_edge(const oriented_surface& s, int n, const std::vector<std::complex<double>>& value,
                       std::uint32_t c);

/// By poly, in n-ths of a full turn.
std::vector<int> indices_of_polys(const oriented_surface& s, int n, const std::vector<std::complex<double>>& value);

struct loop_turn {
  std::uint32_t edge;
  int index;
};
/// The turns of the tangent against the field, by loop, in n-ths of a full turn; the surface is on the left.
std::vector<loop_turn> turns_of_loops(const oriented_surface& s, int n,
                                      const std::vector<std::complex<double>>& value);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/directions/detail/surface/field_indices.ipp>
#endif
