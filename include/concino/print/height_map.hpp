// A height map of a part: how high it is above each cell of the plate.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/print/detail/supports/part_surface.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace concino {

struct height_map_options {
  vec3 direction = {0, 0, 1};        // in which heights are measured; of any length but 0
  std::size_t resolution = 256;      // 1 to 16384: the number of cells along the longer edge of the map
  std::optional<double> plate = {};  // height of the plate along the direction, in units of the mesh; without it, at
                                     // the lowest point
};

/// Heights above the plate, row by row: cell (i, j) has its centre at origin + i step_x + j step_y.
struct height_map_result {
  std::size_t columns = 0, rows = 0;
  vec3 origin, step_x, step_y;      // in the plate; the steps have equal lengths and are perpendicular
  std::vector<double> heights;      // heights[j * columns + i]; 0 where nothing is above the plate

  double operator()(std::size_t i, std::size_t j) const { return heights[j * columns + i]; }
};

namespace detail {

height_map_result fill_height_map(const part_surface& part, const height_map_options& options);

}  // namespace detail

/// The height of the part above the centres of the cells of a map: auto h = height_map(m, {.resolution = 512}); h(i, j)
/// Needs:  EmbeddedMesh, of any shape; surfaces may be open. Of a volume it is the boundary.
/// Result: the height of the highest poly above each centre, exact up to rounding; polygons of more than three verts
///         are the triangles of triangulate_polygon. Polys seen edge-on are left out. The map covers the projection of
///         the part, whose width is a multiple of the cell in one direction. For the direction of z, step_x and step_y
///         have the directions of x and y.
/// Cost:   O(n + number of cells that each triangle covers) for n polys.
/// Errors: invalid_mesh as overhangs; invalid_argument if an option is out of its range.
template<EmbeddedMesh M>
height_map_result height_map(const M& m, const height_map_options& options = {}) {
  return detail::fill_height_map(detail::outer_surface(m, "height_map").surface, options);
}

// What to write instead of calls that cannot compile.
template<class... T> void height_map(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void height_map(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/print/detail/supports/height_map.ipp>
#endif
