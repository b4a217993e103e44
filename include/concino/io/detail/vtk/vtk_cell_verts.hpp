// The verts of the cells of a VTK file, checked; also of polygons, strips and polyhedra.
#pragma once

#include <concino/io/detail/cells/element_nodes.hpp>
#include <concino/io/detail/vtk/vtk_grid.hpp>

#include <algorithm>
#include <cstddef>

namespace concino::detail {

/// Reads the verts of cells, and checks them. Errors: parse_error for a point that is not there, or a wrong number of
/// points.
class vtk_cell_verts {
  static constexpr unsigned quadratic_polygon = 36;
  bool in_range_ = false;  // all verts are, so that each need not be compared

 protected:
  vtk_grid& grid_;
  const read_context& in_;
  vtk_places& places_;
  const vert_id* verts_ = grid_.verts.data();
  element_nodes nodes_;

  vtk_cell_verts(vtk_grid& grid, const read_context& in, vtk_places& places)
      : grid_(grid), in_(in), places_(places) {}

  /// Needs: a call before those of the other functions.
  void find_largest() {
    if (grid_.largest == vtk_grid::unknown) {
      grid_.largest = 0;
      for (const vert_id v : grid_.verts) grid_.largest = std::max(grid_.largest, v.raw());
    }
    in_range_ = grid_.largest < grid_.points.size();
  }

  bool is_high_order(std::size_t c) const { return linear_vtk_type(grid_.types[c]) != grid_.types[c]; }

  [[noreturn, gnu::noinline, gnu::cold]] void fail_type(std::size_t c) {
    const unsigned type = grid_.types[c];
    if (is_high_order(c))
      core::throw_joined<unsupported>({in_.name, ": the cell at ", places_.place_of_cell(c), " is a ",
                                       type < 68 ? "second-order" : "higher-order", " element, of type ", type,
                                       ", with nodes on edges; ", read_corners_instead});
    core::throw_joined<unsupported>(
        {in_.name, ": the cell at ", places_.place_of_cell(c), " has type ", type,
         "; types from 17 on are not supported, except 42 and elements of second and higher order"});
  }

  /// The verts of a cell, the corners first.
  const vert_id* verts_of(std::size_t c) {
    const std::size_t first = grid_.first(c), n = grid_.cell_ends[c] - first,
                      expected = size_of_vtk_cell(grid_.types[c]);
    if (expected && n != expected)
      places_.fail_at_cell(c, {expected, " points, for a cell of type ", unsigned{grid_.types[c]}}, {n});
    check_verts(c, first, n);
    if (is_high_order(c)) add_nodes(c, verts_ + first, n);
    return verts_ + first;
  }

  /// Calls use(verts, n) for the polygon of a cell, or for each triangle of a strip.
  template<class Use>
  void for_each_polygon(std::size_t c, const Use& use) {
    const vert_id* const v = verts_of(c);
    const std::size_t n = num_corners(c);
    if (grid_.types[c] == 8) {
      const vert_id pixel[] = {v[0], v[1], v[3], v[2]};
      use(pixel, 4);
    } else if (grid_.types[c] == 6) {
      if (n < 3) places_.fail_at_cell(c, {"a strip of at least three points"}, {n});
      for (std::size_t i = 0; i + 2 < n; ++i) {
        const vert_id triangle[] = {v[i + i % 2], v[i + 1 - i % 2], v[i + 2]};
        use(triangle, 3);
      }
    } else {
      if (n < 3) places_.fail_at_cell(c, {"a polygon of at least three points"}, {n});
      use(v, n);
    }
  }

  /// Checks the list of the faces of a polyhedron.
  void check_faces(std::size_t c) {
    std::size_t at = grid_.first(c);
    const std::size_t end = grid_.cell_ends[c];
    const std::size_t faces = at < end ? verts_[at++].raw() : 0;
    for (std::size_t f = 0; f < faces; ++f) {
      const std::size_t n = at < end ? verts_[at++].raw() : ~std::size_t{0};
      if (n > end - at)
        places_.fail_at_cell(c, {"the verts of ", faces, " faces of a polyhedron"}, {"a list that ends in face ", f});
      check_verts(c, at, n);
      at += n;
    }
    if (at != end)
      places_.fail_at_cell(c, {"the end of the polyhedron after ", faces, " faces"}, {end - at, " more numbers"});
    if (faces == 0) places_.fail_at_cell(c, {"a polyhedron of at least one face"}, {"one without faces"});
  }

 private:
  /// The number of corners of a cell, which come first among its verts.
  std::size_t num_corners(std::size_t c) const {
    const std::size_t n = grid_.cell_ends[c] - grid_.first(c);
    if (grid_.types[c] == quadratic_polygon) return n / 2;
    return is_high_order(c) ? size_of_vtk_cell(linear_vtk_type(grid_.types[c])) : n;
  }

  /// Adds the verts of a cell that are no corners to the nodes.
  void add_nodes(std::size_t c, const vert_id* v, std::size_t n) {
    const std::size_t corners = num_corners(c);
    if (grid_.types[c] == quadratic_polygon && n % 2 != 0)
      places_.fail_at_cell(c, {"an even number of points, for a cell of type ", unsigned{grid_.types[c]}}, {n});
    if (n < corners)
      places_.fail_at_cell(c, {"at least ", corners, " points, for a cell of type ", unsigned{grid_.types[c]}}, {n});
    nodes_.add(v + corners, n - corners);
  }

  void check_verts(std::size_t c, std::size_t first, std::size_t n) {
    for (std::size_t i = first; !in_range_ && i < first + n; ++i)
      if (verts_[i].raw() >= grid_.points.size()) fail_vert(c, verts_[i]);
  }

  void fail_vert(std::size_t c, vert_id v) {
    places_.fail_at_cell(c, {"a point index below ", grid_.points.size()}, {v.raw()});
  }
};

}  // namespace concino::detail
