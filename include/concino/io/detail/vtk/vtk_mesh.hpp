// Turns the contents of a VTK file into those of a mesh.
#pragma once

#include <concino/io/cell_builder.hpp>
#include <concino/io/detail/cells/element_nodes.hpp>
#include <concino/io/detail/vtk/vtk_grid.hpp>

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

namespace concino::detail {

/// Turns a grid into the contents of a mesh: a volume if it has cells of a volume, else a surface. Polygons in a volume
/// become listed faces. Contents is volume_contents if the program reads volumes.
template<class Contents>
class vtk_mesh {
  static constexpr unsigned quadratic_polygon = 36;
  static constexpr bool volumes = std::is_same_v<Contents, volume_contents>;

  vtk_grid& grid_;
  const read_context& in_;
  vtk_places& places_;
  Contents& out_;
  const vert_id* verts_ = grid_.verts.data();
  std::vector<std::uint32_t> poly_cells_, face_cells_;  // the cell of each poly or listed face
  bool in_range_ = false;  // all verts are, so that each need not be compared
  element_nodes nodes_;
  std::vector<std::uint64_t> scratch_;

 public:
  vtk_mesh(vtk_grid& grid, const read_context& in, vtk_places& places, Contents& out)
      : grid_(grid), in_(in), places_(places), out_(out) {}

  void make() {
    if (grid_.largest == vtk_grid::unknown) {
      grid_.largest = 0;
      for (const vert_id v : grid_.verts) grid_.largest = std::max(grid_.largest, v.raw());
    }
    in_range_ = grid_.largest < grid_.points.size();
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
    set_columns_of_grid();
    nodes_.remove(out_, *in_.report);
  }

 private:
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
  bool is_high_order(std::size_t c) const { return linear_vtk_type(grid_.types[c]) != grid_.types[c]; }

  /// The number of corners of a cell, which come first among its verts.
  std::size_t num_corners(std::size_t c) const {
    const std::size_t n = grid_.cell_ends[c] - grid_.first(c);
    if (grid_.types[c] == quadratic_polygon) return n / 2;
    return is_high_order(c) ? size_of_vtk_cell(linear_vtk_type(grid_.types[c])) : n;
  }

  /// The verts of a cell, checked, the corners first. Errors: parse_error for a point that is not there, or a wrong
  /// number of points.
  const vert_id* verts_of(std::size_t c) {
    const std::size_t first = grid_.first(c), n = grid_.cell_ends[c] - first,
                      expected = size_of_vtk_cell(grid_.types[c]);
    if (expected && n != expected)
      places_.fail_at_cell(c, {expected, " points, for a cell of type ", unsigned{grid_.types[c]}}, {n});
    check_verts(c, first, n);
    if (is_high_order(c)) add_nodes(c, verts_ + first, n);
    return verts_ + first;
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

  /// Moves the values of verts, and copies those of cells to the polys and faces that the cells became. Values of faces
  /// only, or of polys only, have default values at the others in the file: they become no property of these.
  void set_columns_of_grid() {
    constexpr element_kind kinds[] = {element_kind::vert, element_kind::poly, element_kind::face, element_kind::mesh};
    for (const element_kind kind : kinds)
      for (property_column& c : grid_.columns) {
        const bool of_cells = kind == element_kind::poly || kind == element_kind::face;
        if (c.kind != (of_cells ? element_kind::poly : kind)) continue;
        if (kind == element_kind::poly && !face_cells_.empty() && !has_value(c, poly_cells_) &&
            has_value(c, face_cells_))
          continue;
        if (kind == element_kind::face && (face_cells_.empty() || !has_value(c, face_cells_))) continue;
        if (!of_cells ||
            (kind == element_kind::poly && (poly_cells_.size() == grid_.size() && is_identity(poly_cells_)))) {
          out_.properties.push_back(std::move(c));
          continue;
        }
        const std::vector<std::uint32_t>& cells = kind == element_kind::poly ? poly_cells_ : face_cells_;
        const value_type& type = c.values->operations();
        auto* const to = static_cast<unsigned char*>(out_.add_property(kind, c.name, type, cells.size()));
        const auto* const from = static_cast<const unsigned char*>(c.values->data());
        for (std::size_t i = 0; i < cells.size(); ++i)
          std::memcpy(to + i * type.size, from + cells[i] * type.size, type.size);
      }
  }
  /// Whether one of the cells has a value other than the default one.
  static bool has_value(const property_column& c, const std::vector<std::uint32_t>& cells) {
    const value_type& type = c.values->operations();
    const column defaults(type, 1);
    const auto* const values = static_cast<const unsigned char*>(c.values->data());
    for (const std::uint32_t i : cells)
      if (std::memcmp(values + i * type.size, defaults.data(), type.size) != 0) return true;
    return false;
  }
  static bool is_identity(const std::vector<std::uint32_t>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (cells[i] != i) return false;
    return true;
  }
};

}  // namespace concino::detail
