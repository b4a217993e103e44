// Turns the contents of a VTK file into those of a mesh.
#pragma once

#include <concino/io/cell_builder.hpp>
#include <concino/io/detail/vtk/vtk_cell_verts.hpp>
#include <concino/io/detail/vtk/vtk_properties.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace concino::detail {

/// Turns a grid into the contents of a mesh: a volume if it has cells of a volume, else a surface. Polygons in a volume
/// become listed faces. Contents is volume_contents if the program reads volumes.
template<class Contents>
class vtk_mesh : vtk_cell_verts {
  static constexpr bool volumes = std::is_same_v<Contents, volume_contents>;

  Contents& out_;
  std::vector<std::uint32_t> poly_cells_, face_cells_;  // the cell of each poly or listed face
  std::vector<std::uint64_t> scratch_;

 public:
  vtk_mesh(vtk_grid& grid, const read_context& in, vtk_places& places, Contents& out)
      : vtk_cell_verts(grid, in, places), out_(out) {}

  void make() {
    find_largest();
    std::size_t count[5] = {};
    for (std::size_t c = 0, end; c < grid_.size(); c = end) {
      const vtk_kind k = kind_of_vtk_cell(grid_.types[c]);
      if (k == vtk_kind::unknown || (k != vtk_kind::line && is_high_order(c) && !in_.corners_only)) fail_type(c);
      for (end = c + 1; end < grid_.size() && grid_.types[end] == grid_.types[c];) ++end;
      count[static_cast<unsigned>(k)] += end - c;
    }
    const std::size_t num_polygons = count[static_cast<unsigned>(vtk_kind::polygon)],
                      num_cells = count[static_cast<unsigned>(vtk_kind::cell)];
    if (num_cells ? !volumes : !in_.wanted.surface && num_polygons > 0)
      throw_wrong_dimension(in_.name, num_cells != 0, num_cells ? num_cells : num_polygons);
    if (num_cells && !in_.wanted.cells && !in_.wanted.polyhedra) throw_wrong_dimension(in_.name, true, num_cells);
    if (const std::size_t lines = count[static_cast<unsigned>(vtk_kind::line)])
      in_.report->skipped.push_back(core::joined({lines, " cells that are verts or lines"}));
    bool has_values = false;
    for (const property_column& c : grid_.columns) has_values = has_values || c.kind == element_kind::poly;
    if (num_cells && num_polygons && !has_values)
      in_.report->skipped.push_back(core::joined(
          {num_polygons, " polygons: the faces of a volume are those of its cells, and these have no values"}));
    if (grid_.num_ghosts) in_.report->skipped.push_back(core::joined({grid_.num_ghosts, " ghost cells"}));
    const bool is_volume = num_cells || !in_.wanted.surface;
    if (!is_volume) make_surface();
    if constexpr (volumes) {
      if (is_volume) make_volume(has_values);
    }
    std::vector<vert_id>().swap(grid_.verts);
    set_properties_from_grid(grid_, poly_cells_, face_cells_, out_);
    nodes_.remove(out_, *in_.report);
  }

 private:
  static constexpr polygon_words words_{"different points at the corners of a polygon", "point "};
  /// The verts of a face that is listed. Without options.repeated_verts they have to be different; with it, equal
  /// neighbours become one.
  std::vector<vert_id> listed_face(std::size_t c, const vert_id* v, std::size_t n) {
    std::vector<vert_id> face(v, v + n);
    const std::size_t k = first_repeated(v, n, scratch_);
    if (k == n) return face;
    if (out_.repeated.policy == repeated_verts::refuse)
      places_.fail_at_cell(c, {words_.different, repeated_verts_hint}, {words_.vert, v[k].raw(), " twice"});
    face.resize(collapse_verts(face.data(), static_cast<std::uint32_t>(n)));
    return face;
  }

  void make_surface() {
    surface_arrays& s = out_.surface;
    std::uint32_t arity = 0;
    s.verts.reserve(grid_.verts.size());
    for (std::size_t c = 0; c < grid_.size(); ++c) {
      if (kind_of_vtk_cell(grid_.types[c]) != vtk_kind::polygon) continue;
      for_each_polygon(c, [&](const vert_id* v, std::size_t n) {
        check_read_polygon(
            out_, in_.wanted, v, n, words_, scratch_,
            [&](core::message expected, core::message found) { places_.fail_at_cell(c, expected, found); },
            [&] { return poly_cells_.size(); },
            [&] {
              return core::joined({"at ", places_.place_of_cell(c)});
            });
        const std::size_t first = s.verts.size();
        for (std::size_t i = 0; i < n; ++i) s.verts.push_back(v[i]);
        if (s.verts.size() > max_ids) core::throw_joined<unsupported>({in_.name, ": more than ", max_ids, " corners"});
        end_poly(s, arity, first);
        poly_cells_.push_back(static_cast<std::uint32_t>(c));
      });
    }
    s.points = std::move(grid_.points);
    if (s.offsets.empty()) s.arity = arity ? arity : in_.wanted.arity;
    if (s.offsets.empty() && s.arity == 0) s.offsets.push_back(0);
  }

  void make_volume(bool lists_faces) {
    basic_cell_builder<Contents> cells(in_, grid_.points, 0);
    swap_orders();
    const cell_shape first = grid_.size() > 0 ? shape_of_vtk_cell(grid_.types[0]) : cell_shape::general;
    if (first != cell_shape::general) cells.reserve(first, grid_.size());
    for (std::size_t c = 0; c < grid_.size(); ++c) {
      const vtk_kind kind = kind_of_vtk_cell(grid_.types[c]);
      if (kind == vtk_kind::polygon) list_faces(c, lists_faces);
      if (kind != vtk_kind::cell) continue;
      if (!add_cell(cells, c)) places_.fail_at_cell(c, {cells.expected}, {cells.found});
      poly_cells_.push_back(static_cast<std::uint32_t>(c));
    }
    cells.finish(out_);
  }

  /// Puts the verts of all cells into the standard order. Cells of a wrong number of verts stay as they are: they are
  /// rejected later.
  void swap_orders() {
    for (std::size_t c = 0; c < grid_.size(); ++c)
      if (grid_.cell_ends[c] - grid_.first(c) == size_of_vtk_cell(grid_.types[c]))
        swap_vtk_order(grid_.types[c], grid_.verts.data() + grid_.first(c));
  }
  /// Checks the polygons of a cell, and lists them as faces.
  void list_faces(std::size_t c, bool listed) {
    for_each_polygon(c, [&](const vert_id* v, std::size_t n) {
      const std::vector<vert_id> face = listed_face(c, v, n);
      if (!listed) return;
      out_.faces.verts.insert(out_.faces.verts.end(), face.begin(), face.end());
      out_.faces.end_element();
      face_cells_.push_back(static_cast<std::uint32_t>(c));
    });
  }

  template<class Builder>
  bool add_cell(Builder& cells, std::size_t c) {
    const unsigned type = linear_vtk_type(grid_.types[c]);
    if (type == vtk_polyhedron) return add_polyhedron(cells, c);
    const vert_id* const v = verts_of(c);
    if (type == 15 || type == 16) {
      const std::size_t n = type == 15 ? 5 : 6;
      vert_id base[6];
      std::reverse_copy(v, v + n, base);
      cells.add_face(base, n);
      cells.add_face(v + n, n);
      for (std::size_t i = 0; i < n; ++i) {
        const vert_id quad[] = {v[i], v[(i + 1) % n], v[n + (i + 1) % n], v[n + i]};
        cells.add_face(quad, 4);
      }
      return cells.end_polyhedron();
    }
    return cells.add_cell(shape_of_vtk_cell(type), v);
  }

  template<class Builder>
  bool add_polyhedron(Builder& cells, std::size_t c) {
    check_faces(c);
    const vert_id* v = verts_ + grid_.first(c);
    for (std::uint32_t left = v++->raw(); left > 0; --left) {
      const std::uint32_t n = v++->raw();
      cells.add_face(v, n);
      v += n;
    }
    return cells.end_polyhedron();
  }
};

}  // namespace concino::detail
