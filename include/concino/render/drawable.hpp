// Drawables: polygons with the triangles, normals, values and colours that pictures need.
#pragma once

#include <concino/core/vec3.hpp>
#include <concino/geometry/triangulate_polygon.hpp>
#include <concino/render/appearance.hpp>
#include <concino/render/inspected_mesh.hpp>
#include <concino/render/smooth_normals.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace concino {

/// The elements of a drawable that carry its values and colours.
enum class value_place : std::uint8_t { points, polygons, corners };

/// Polygons prepared for rendering, such as those of the surface of a mesh. Lengths are in units of the mesh.
struct drawable {
  std::vector<vec3> points;
  std::vector<double> values;                           // by the elements `values_at`; empty: no values
  value_place values_at = value_place::points;
  std::vector<rgb> colors;                              // by the elements `colors_at`, instead of values; empty: none
  value_place colors_at = value_place::polygons;
  std::vector<double> edge_values;                      // by corner: of the edge to the next corner; empty: edges have
                                                        // one colour
  std::vector<std::array<float, 2>> texture_coordinates;  // by corner; empty: no texture
  std::vector<std::uint8_t> exposed;                    // by polygon: 1 if a cut laid it bare; empty: none is
  std::vector<std::uint32_t> offsets = {0};             // polygon p has the corners offsets[p] .. offsets[p+1]-1
  std::vector<std::uint32_t> corners;                   // the point of each corner
  std::vector<std::array<float, 3>> normals;            // by corner, unit vectors
  std::vector<std::uint32_t> polys;                     // by polygon: index_of its poly in the mesh
  std::vector<std::uint32_t> mesh_polygons;             // by polygon: index_of it in the mesh, that is of a poly of a
                                                        // surface or a face of a volume
  std::vector<std::uint32_t> verts;                     // by point: index_of its vert in the mesh
  std::vector<std::array<std::uint32_t, 3>> triangles;  // the three corners of each
  std::vector<std::uint32_t> polygon_of;                // by triangle
  appearance look;
  std::string name;                                     // in pages; empty: a number
  std::shared_ptr<const inspected_mesh> inspected;      // for pages; null: nothing but the polygons is kept

  polygon_list polygons() const { return {points, offsets, corners}; }
};

namespace detail {

/// Triangulates the polygons.
inline void add_triangles(drawable& d) {
  polygon_triangulator cut;
  std::vector<vec3> polygon;
  for (std::size_t p = 0; p + 1 < d.offsets.size(); ++p) {
    const std::uint32_t first = d.offsets[p], last = d.offsets[p + 1], index = static_cast<std::uint32_t>(p);
    if (last - first == 3) {
      d.triangles.push_back({first, first + 1, first + 2});
      d.polygon_of.push_back(index);
      continue;
    }
    polygon.clear();
    for (std::uint32_t c = first; c < last; ++c) polygon.push_back(d.points[d.corners[c]]);
    for (const polygon_triangle& t : cut(polygon)) {
      d.triangles.push_back({first + t[0], first + t[1], first + t[2]});
      d.polygon_of.push_back(index);
    }
  }
}

}  // namespace detail

}  // namespace concino
