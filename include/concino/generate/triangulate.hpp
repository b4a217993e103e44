// triangulate: triangles inside outlines, with holes, open lines and isolated points, without new points.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/generate/planar_graph.hpp>

#include <vector>

namespace concino {

struct triangulate_options {
  std::vector<vec3> holes = {};  // a point inside each hole; if there are any, nothing else is a hole: all else that
                                 // outlines and lines enclose is filled
  vec3 seen_from = {0, 0, 1};    // the direction from which triangles are counter-clockwise; not 0. Points are
                                 // projected along it
  bool merge_points = false;     // whether points at the same place are one vert; otherwise they are an error
};

/// Triangulates what is inside of outlines, without new points; so the triangles may be thin.
/// Needs:  outlines in any orientation and order, which may repeat their first point at the end. Lines and outlines may
///         have points and segments in common, but must not meet elsewhere.
/// Result: triangles for what is inside an odd number of outlines: outlines within outlines are holes, and those within
///         holes are islands. With options.holes instead, all bounded regions but these holes. Triangles are
///         counter-clockwise seen from options.seen_from. Verts have the coordinates and the order of the points;
///         points outside, and points on no line that are not isolated, have no vert. Each segment inside or on the
///         boundary is an edge. If all n verts are on the boundary, and no two of h holes touch each other or the
///         outline, there are n + 2h - 2 triangles. A hole may touch an outline at a common point, where a vert with
///         several fans results. Decisions are exact for points seen along an axis; otherwise the projected points are
///         rounded.
/// Cost:   O(n log n).
/// Errors: invalid_argument that names the point that is not finite, is at the place of another one or lies on a
///         segment. It names segments that cross or overlap, and lines with too few points, with a number that is not
///         one of a point, or twice with the same point in a row. It names the hole point that is not finite, lies on a
///         segment or lies in no bounded region. The same if the arrays of g do not fit each other, or if seen_from is
///         0 or not finite.
/// Source: Garey, Johnson, Preparata, Tarjan 1978 for bridges to holes and for large regions; small ones by
///         polygon_triangulator; Shewchuk 1997 for exact tests.
planar_triangulation triangulate(const planar_graph& g, const triangulate_options& options = {});

// What to write instead of calls that cannot compile.
template<class... T> void triangulate(mistake::any_mesh, ...) = delete;  // it takes outlines, a planar_graph; the triangles of a surface are to_triangles(m)

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/generate/detail/outlines/triangulate.ipp>
#endif
