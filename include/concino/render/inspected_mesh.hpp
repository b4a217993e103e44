// What a drawable keeps of its mesh for pages in which elements are picked and the mesh is cut.
#pragma once

#include <concino/core/vec3.hpp>
#include <concino/mesh/property_set.hpp>
#include <concino/render/color.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace concino {

/// Values at the elements of a kind: those that give the colours, or a named property.
struct inspected_values {
  std::string name;
  element_kind at = element_kind::vert;
  std::size_t width = 1;           // numbers for each element
  std::vector<double> numbers;     // by index times width; NaN at indices without an element. Of corners: by place in
                                   // the lists of corners of an inspected_mesh
  std::vector<std::string> texts;  // by index, instead of numbers
};

/// The elements of a mesh by their indices. Indices without an element have points that are not a number, edges between
/// no verts, and polygons and polys without corners and faces.
struct inspected_mesh {
  bool is_volume = false;
  double crease_angle = 60;                     // degrees
  std::vector<vec3> points;                     // by vert
  std::vector<std::uint32_t> edge_verts;        // two by edge
  std::vector<std::uint32_t> polygon_offsets;   // polygon p, a poly of a surface or a face of a volume, has the
  std::vector<std::uint32_t> polygon_verts;     // verts polygon_verts[polygon_offsets[p]] .. [polygon_offsets[p+1]-1]
  std::vector<std::uint32_t> triangles;         // three places in polygon_verts each; empty: all are triangles
  std::vector<std::uint32_t> poly_offsets;      // of a volume: likewise for
  std::vector<std::uint32_t> poly_faces;        // the faces of polys: 2 face, + 1 if the face is not outward
  std::vector<std::uint32_t> corner_offsets;    // of a volume that has values at corners: poly p has the corners
  std::vector<std::uint32_t> corner_verts;      // corner_verts[corner_offsets[p]] .. [corner_offsets[p+1]-1], in the
                                                // order of adj_p2v. Those of surfaces are those of polygons
  std::vector<vec3> centroids;                  // by poly
  std::vector<std::uint8_t> visible;            // by poly: 1 if it is shown; empty: all are
  std::vector<std::uint8_t> exposed;            // by polygon: 1 if a cut laid it bare; empty: none is
  std::vector<rgb> colors;                      // by the elements `colors_at`; empty: none
  element_kind colors_at = element_kind::vert;  // vert, poly, face or corner
  bool has_field = false;                       // the first values are those that give the colours
  bool has_texture = false;                     // the last values are the texture coordinates, two each
  std::vector<inspected_values> values;
};

}  // namespace concino
