// The polys of a volume that a level set crosses, in flat arrays.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/local_numbers.hpp>
#include <concino/core/vec3.hpp>
#include <concino/level_sets/detail/cut/level_place.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Cells and their facets. A facet is a face seen from one cell: a face between two crossed cells has two facets. A
/// crossed face on the boundary that is not planar is replaced by the triangles from its edges to the mean of its
/// points, so that the volume of the parts of its cell is that of the cell.
class crossed_volume {
 public:
  static constexpr std::uint32_t none = ~0u;

  /// A face that was replaced by triangles.
  struct fan {
    std::uint32_t first_facet, last_facet;
    std::uint32_t first_corner, last_corner;  // of the face as it was, in whole_verts and whole_edges
  };
  /// The centre of such a face.
  struct centre {
    std::uint32_t vert, first_edge;  // edge k joins corner k and the centre
    std::uint32_t facet;              // one that belonged to the face
  };

  std::vector<std::uint32_t> first_facet{0};    // by cell, one more than there are cells
  std::vector<std::uint32_t> faces;            // by facet: the index of the face
  std::vector<unsigned char> outward;          // by facet: whether its corners are counter-clockwise seen from outside
                                               // the cell
  std::vector<unsigned char> num_polys;        // by facet: of the face in the whole volume; 3 means 3 or more
  std::vector<std::uint32_t> fan_of;           // by facet, or none
  std::vector<std::uint32_t> first_corner{0};  // by facet, one more than there are facets
  std::vector<std::uint32_t> verts;            // by corner, in the order of adj_f2v: the number of the vert
  std::vector<std::uint32_t> edges;            // by corner: the index of the edge to the next corner
  std::vector<std::uint32_t> vert_indices;     // by vert; none at the centre of a face
  std::vector<vec3> points;
  std::vector<double> values;
  std::vector<unsigned char> states;           // see level_states.hpp
  std::vector<fan> fans;
  std::vector<std::uint32_t> whole_verts, whole_edges;
  std::vector<centre> centres;

  /// Makes room for cells with so many facets and corners, and for three verts a cell; more is made when it is needed.
  void reserve(std::size_t num_cells, std::size_t num_facets, std::size_t num_corners);
  explicit crossed_volume(double level, std::size_t edge_bound) : level_(level), next_edge_(edge_bound) {}

  double level() const { return level_; }
  std::uint32_t num_cells() const { return static_cast<std::uint32_t>(first_facet.size() - 1); }
  std::uint32_t num_facets() const { return static_cast<std::uint32_t>(faces.size()); }
  std::uint32_t num_corners() const { return static_cast<std::uint32_t>(verts.size()); }

  /// The vert with an index; a new one if size() is the result, whose point, value and state then follow.
  std::uint32_t number_of_vert(std::size_t index) { return numbers_.add(index); }
  void add_vert(std::uint32_t index, const vec3& x, double value);
  /// Where the level set crosses an element, or its diagonal, between a vert below and one above.
  level_place place_between(level_place::kind_type kind, std::uint32_t element, std::uint32_t a, std::uint32_t b) const;

  /// Ends a facet whose corners were added to verts and edges.
  void end_facet(std::uint32_t face, bool is_outward, unsigned char polys);
  void end_cell() { first_facet.push_back(num_facets()); }

 private:
  double level_;
  std::size_t next_edge_;  // edges to centres have indices from the bound of the edges on
  core::local_numbers numbers_, centre_numbers_;
  std::vector<vec3> facet_points_;

  void push_facet(std::uint32_t face, bool is_outward, unsigned char polys, std::uint32_t fan_number);
  void replace_by_fan(std::uint32_t face, bool is_outward, unsigned char polys);
  std::uint32_t centre_of(std::uint32_t face, std::uint32_t first, std::uint32_t last);
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/level_sets/detail/cut/crossed_volume.ipp>
#endif
