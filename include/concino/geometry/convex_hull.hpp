// The convex hull of points in space, as polygons from which a mesh can be made. Exact tests decide.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>
#include <concino/mesh/arrays.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace concino {

/// A convex hull: a closed surface of convex polygons, counter-clockwise seen from outside.
struct convex_hull_result {
  surface_arrays surface;            // polygonmesh(std::move(hull.surface)) is a mesh of it
  std::vector<std::size_t> corners;  // the point of the input at each vert of the surface, in increasing order; of
                                     // equal points the first
  int dimension = -1;                // of the hull: 3; 2 if all points are in a plane, 1 on a line, 0 equal; -1 without
                                     // points
};

/// The convex hull of points: auto hull = convex_hull(points); const polygonmesh m(hull.surface);
/// Needs:  points in any order and number; many may be equal, collinear or coplanar.
/// Result: the corners of the hull, and its faces. A corner is on no segment between other points. Points in one plane
///         give one polygon, whatever their number. In dimension 2 there are two polygons on the same verts, seen from
///         either side; in dimension 1 and 0 two verts or one, and no polygons. The polygons are sorted, and each
///         begins at its first corner: except for these numbers, the order of the points has no influence. It is as
///         exact as orient3d, for coordinates divided by the largest one. So points that were rounded are in one plane
///         only if they still are.
/// Cost:   O(n log n) time, expected over the order in which points are added, which is random and the same each time;
///         O(n) memory.
/// Errors: invalid_argument if a point is not finite, or if there are more than 2^32 - 2 of them.
/// Source: Clarkson and Shor 1989, "Applications of random sampling in computational geometry, II"; Barber, Dobkin and
///         Huhdanpaa 1996 for the sets of points outside of each facet; Andrew 1979 in the plane.
convex_hull_result convex_hull(std::span<const vec3> points);

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/geometry/detail/hull/convex_hull.ipp>
#endif
