// Connections with given holonomy: the angles by which they turn directions at edges beyond parallel transport.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/directions/detail/surface/oriented_surface.hpp>
#include <concino/directions/detail/surface/poly_planes.hpp>

#include <cstdint>
#include <vector>

namespace concino::detail {

/// A closed strip of polys, by the corners whose edges it crosses from the poly of the corner to the next one.
using poly_strip = std::vector<std::uint32_t>;

/// The strip of each edge of `rest` through the tree of polys that crosses the edges `cotree`.
std::vector<poly_strip> strips_of(const oriented_surface& s, const std::vector<std::uint32_t>& cotree,
                                  const std::vector<std::uint32_t>& rest);

/// The turn of a direction along a strip against the strip itself, by parallel transport.
double turn_of_strip(const oriented_surface& s, const poly_planes& planes, const poly_strip& strip);

/// 2 pi minus the angles of the polys, by vert; 0 at verts without polys.
/// Errors: unsupported if a poly, projected to its plane, crosses itself, so that its angles have another sum.
std::vector<double> defects_of(const oriented_surface& s, const poly_planes& planes, const char* caller);

struct trivial_turns {
  std::vector<double> turn;       // by corner: crossing its edge, minus that of its twin
  std::vector<double> holonomy;   // by vert, of the connection
  std::vector<double> of_strip;   // the turn of directions along each strip against the strip
};

/// The turns of the smallest sum of squares with these holonomies, in radians. strip_turns: of each strip, or empty:
/// the multiples of `step` that are nearest to those of the turns without this condition.
trivial_turns find_trivial_turns(const oriented_surface& s, const poly_planes& planes,
                                 const std::vector<double>& holonomy, const std::vector<double>& defects,
                                 const std::vector<poly_strip>& strips, std::vector<double> strip_turns, double step);

/// By poly: the angle of a direction in its plane, carried from the first poly of each component by the connection.
/// start: a poly whose angle is given.
std::vector<double> carried_angles(const oriented_surface& s, const poly_planes& planes, const trivial_turns& turns,
                                   std::uint32_t start, double angle);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/directions/detail/connection/trivial_turns.ipp>
#endif
