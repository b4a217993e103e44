// Connections with given holonomy: the angles by which they turn directions at edges beyond parallel transport.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/directions/detail/surface/oriented_surface.hpp>
#include <concino/directions/detail/surface/poly_planes.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace concino::detail {

/// By vert: the vert itself, or the smallest of its loop of the boundary.
std::vector<std::uint32_t> points_and_loops(const oriented_surface& s);

/// A closed strip of polys, by the corners whose edges it crosses from the poly of the corner to the next one.
using poly_strip = std::vector<std::uint32_t>;

/// Strips that generate all closed ones, together with those around verts and loops of the boundary: each crosses one
/// more edge than a breadth-first tree of polys, that of its first corner, and returns through the tree.
std::vector<poly_strip> generating_strips(const oriented_surface& s, const std::vector<std::uint32_t>& place);

/// The turn of a direction along a strip against the strip itself, by parallel transport.
double turn_of_strip(const oriented_surface& s, const poly_planes& planes, const poly_strip& strip);

/// By place: 2 pi minus the angles of the polys at the vert, or the sum of pi minus these over the verts of the loop; 0
/// elsewhere, and at verts without polys.
/// Errors: unsupported if a poly, projected to its plane, crosses itself, so that its angles have another sum.
std::vector<double> defects_of(const oriented_surface& s, const poly_planes& planes,
                               const std::vector<std::uint32_t>& place, const char* caller);

/// What the holonomy of a connection is to be, in radians.
struct wanted_turns {
  std::vector<std::uint32_t> place;             // by vert, see points_and_loops
  std::vector<std::optional<double>> holonomy;  // by place; empty at loops that turn least
  std::vector<double> of_strip;                 // along each strip against it; empty: those that turn least
  double step = 0;                              // turns that are not given are multiples of it
};

struct trivial_turns {
  std::vector<double> turn;       // by corner: crossing its edge, minus that of its twin; 0 at the boundary
  std::vector<double> holonomy;   // by place, of the connection
  std::vector<double> of_strip;   // the turn of directions along each strip against the strip
};

/// The turns of the smallest sum of squares with this holonomy, in radians. What is not given is the multiple of the
/// step that is nearest to what it is without this condition; the last such loop of a component follows from the sum.
trivial_turns find_trivial_turns(const oriented_surface& s, const poly_planes& planes,
                                 const std::vector<double>& defects, const std::vector<poly_strip>& strips,
                                 const wanted_turns& wanted);

/// By poly: the angle of a direction in its plane, carried from the first poly of each component by the connection.
/// start: a poly whose angle is given.
std::vector<double> carried_angles(const oriented_surface& s, const poly_planes& planes, const trivial_turns& turns,
                                   std::uint32_t start, double angle);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/directions/detail/connection/trivial_turns.ipp>
#endif
