// Cuts the faces of volumes into triangles and their cells into tets.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/function_ref.hpp>
#include <concino/generate/detail/outlines/flat_triangles.hpp>
#include <concino/mesh/arrays.hpp>
#include <concino/mesh/element_origins.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// The triangles of all faces, which do not depend on the cells at a face. A face is cut at its vert of the smallest
/// number, if all triangles there have the orientation of the face; otherwise as to_triangles does.
class face_triangles {
  std::vector<std::size_t> first_, last_;  // by index of a face, in corners_
  std::vector<vert_id> corners_;
  std::vector<vec3> points_;  // of a face
  polygon_cutter cut_;

  bool is_fan(std::size_t from) const;

 public:
  explicit face_triangles(std::size_t face_bound) : first_(face_bound), last_(face_bound) {}
  void add(std::size_t face, std::span<const vert_id> verts, std::span<const vec3> points);
  /// The corners of the triangles of a face, three by three.
  std::span<const vert_id> operator[](std::size_t face) const {
    return {corners_.data() + first_[face], corners_.data() + last_[face]};
  }
};

/// Cuts one cell after another into tets.
class cell_cutter {
  std::vector<vert_id> outer_, far_;      // triangles of the current cell, which face outward: all, and those that are
                                          // joined with its apex
  unsigned triangles_ = 0, quads_ = 0;    // faces of the current cell that were cut into one and into two
  bool has_others_ = false;
  double scale_ = 1;                      // multiplied with coordinates, so that orient3d neither overflows nor
                                          // underflows
  std::vector<std::uint32_t> poly_;       // of each tet, the index of its cell
  std::vector<double> weight_;            // of each tet: its part of the cell

  bool is_positive(vert_id a, vert_id b, vert_id c, vert_id d) const;
  bool is_standard_cell(std::size_t num_verts) const;
  void add_tet(vert_id a, vert_id b, vert_id c, vert_id d);
  bool join(vert_id apex);
  void cut_corner(vert_id apex);
  bool cut_at_smallest_vert(bool is_hex);
  void set_weights(std::size_t first);

 public:
  cell_arrays tets;                        // their points, and after them those of new verts
  std::vector<poly_id> inverted;           // tets without positive volume
  std::vector<std::size_t> inverted_cells; // the indices of cells with such tets

  explicit cell_cutter(std::vector<vec3> points);

  void begin_cell();
  void add_face(std::span<const vert_id> corners, bool outward);
  /// Cuts the current cell, which has num_verts verts. Returns whether there is a new vert in it, at mean().
  bool cut(std::size_t poly, std::size_t num_verts, function_ref<vec3()> mean);
  /// The cell of each tet, weighted by volume.
  element_origins poly_origins() const;
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/generate/detail/volumes/cell_tets.ipp>
#endif
