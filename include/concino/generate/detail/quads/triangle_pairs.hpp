// Joins triangles in pairs to quads.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/mesh/arrays.hpp>
#include <concino/mesh/element_origins.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// The triangles of a surface. Corner i of the list is at vert verts[i]; the edge to the next corner of its triangle is
/// edges[i].
struct triangle_list {
  std::vector<vec3> points;
  std::vector<vert_id> verts;
  std::vector<std::uint32_t> edges;  // indices below num_edges
  std::vector<std::uint32_t> polys;  // of each triangle, the index in its mesh
  std::size_t num_edges = 0;
};

/// Quads and triangles, in the order of the first triangle of each.
struct joined_triangles {
  surface_arrays polygons;
  element_origins from;  // the poly or the two polys of each, weighted by area
  std::vector<poly_id> triangles;  // those that are not joined
};

/// Joins as many triangles as possible. Each quad is convex, and its corners are smaller than max_angle, in radians.
joined_triangles join_triangles(triangle_list&& list, double max_angle);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/generate/detail/quads/triangle_pairs.ipp>
#endif
