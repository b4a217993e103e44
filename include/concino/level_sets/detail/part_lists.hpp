// The parts of cells that a level set cuts, as polyhedra with common faces.
#pragma once

#include <concino/core/vec3.hpp>
#include <concino/level_sets/detail/level_place.hpp>

#include <cstdint>
#include <vector>

namespace concino::detail {

/// Faces and parts of cells. Cells that are left whole have one part.
struct part_lists {
  /// In face_places and part_faces: what follows is the index of a vert or a face of the mesh.
  static constexpr std::uint32_t of_mesh = std::uint32_t{1} << 31;

  struct face {
    std::uint32_t first, last;  // in face_places
    std::uint32_t origin;       // the index of the face of the mesh of which it is a part; none for the cap of a loop
    bool is_whole;              // it is that face
    bool is_cut;                // it is between a part below and a part above
  };
  struct part {
    std::uint32_t cell;
    std::uint32_t first, last;  // in part_faces
    bool is_above;
    bool is_whole;              // it is the whole cell, whose faces are all whole
  };

  std::vector<face> faces;
  std::vector<std::uint32_t> face_places;  // places, by number
  std::vector<part> parts;                 // by cell
  std::vector<std::uint32_t> part_faces;   // faces, by number
  std::vector<unsigned char> outward;      // by entry of part_faces: whether the places are counter-clockwise seen from outside the part
  std::vector<level_place> places;
  std::vector<std::uint32_t> first_faces;  // by place: the index of the face of the mesh for which it was numbered; only cell_parts lists it
};

/// The verts at the ends of places.
struct place_ends {
  std::vector<std::uint32_t> vert_indices;  // none if a vert is the centre of a face
  std::vector<vec3> points;
  std::vector<double> values;
};

}  // namespace concino::detail
