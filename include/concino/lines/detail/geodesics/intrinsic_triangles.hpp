// Triangles that are known by the lengths of their edges, so that edges can be flipped without changing the surface.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/unfolded_triangles.hpp>

#include <cstddef>
#include <vector>

namespace concino::detail {

/// Half-edges with consistent orientation. Half-edges without a triangle, on the boundary, have no next one.
struct intrinsic_triangles {
  std::vector<int> start, next, twin;  // by half-edge; next: -1 without a triangle
  std::vector<double> length;          // by half-edge
  std::vector<double> fan_angle;       // by half-edge: its direction in the fan about its start, on the surface of the
                                       // triangles before all flips
  std::vector<signed char> sense;      // by vert: 1 where angles of the fan increase counter-clockwise, else -1
  std::vector<int> first_at;           // by vert: one of its half-edges, -1 without triangles

  /// Errors: unsupported if the surface is not orientable, or not manifold.
  intrinsic_triangles(const core::unfolded_triangles& t, const char* caller);

  static std::size_t at(int h) { return static_cast<std::size_t>(h); }
  bool has_triangle(int h) const { return next[at(h)] >= 0; }
  int previous(int h) const { return next[at(next[at(h)])]; }
  int end(int h) const { return start[at(twin[at(h)])]; }
  /// The half-edge with the same start that is next counter-clockwise, -1 if the boundary is between.
  int counter_clockwise(int h) const { return has_triangle(h) ? twin[at(previous(h))] : -1; }
  /// The number of an edge, the same for both half-edges.
  int edge(int h) const { return h < twin[at(h)] ? h : twin[at(h)]; }

  /// The angle between half-edge h and the next one counter-clockwise.
  double corner_angle(int h) const;

  /// Flips the edge of h, which has triangles on both sides that make a convex quadrilateral.
  void flip(int h);
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/lines/detail/geodesics/intrinsic_triangles.ipp>
#endif
