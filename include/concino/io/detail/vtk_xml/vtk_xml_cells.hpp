// Reads the points and cells of the pieces of .vtu and .vtp files into a grid.
#pragma once

#include <concino/io/detail/cells/corners.hpp>
#include <concino/io/detail/vtk/vtk_grid.hpp>
#include <concino/io/detail/vtk_xml/vtk_xml_tags.hpp>
#include <concino/mesh/support/limits.hpp>

#include <cstring>

namespace concino::detail {

class vtk_xml_cells : public vtk_xml_data {
 protected:
  vtk_grid& grid_;
  vtk_xml_index index_;
  std::vector<std::size_t> first_point_, first_cell_;  // of each piece, and the end
  bool has_faces_ = false;                             // the grid has the faces of polyhedra instead of their verts
  bool reads_polyhedra_ = false;

  vtk_xml_cells(const read_context& in, vtk_grid& grid) : vtk_xml_data(in), grid_(grid) {}
  ~vtk_xml_cells() = default;

  /// Null if there is none.
  const vtk_xml_array* find(std::size_t piece, vtk_xml_part part, std::string_view name) const {
    for (std::size_t i = index_.pieces[piece].first_entry;
         i < index_.entries.size() && index_.entries[i].piece == piece; ++i) {
      const vtk_xml_entry& e = index_.entries[i];
      if (e.part == part && (name.empty() || e.array.name == name)) return &e.array;
    }
    return nullptr;
  }
  const vtk_xml_array& need(std::size_t piece, vtk_xml_part part, std::string_view name) const {
    const vtk_xml_array* const a = find(piece, part, name);
    if (!a)
      fail(index_.pieces[piece].at, {"the array \"", name.empty() ? "Points" : name, "\""}, {"a piece without it"});
    return *a;
  }

  void points(std::size_t p) {
    const std::uint64_t n = index_.pieces[p].points;
    if (n == 0) return;
    const vtk_xml_array& a = need(p, vtk_xml_part::points, "");
    if (a.components != 3) fail_array(a, {"three components"}, {a.components});
    if (n > max_ids || grid_.points.size() + n > max_ids) fail_to_count("points");
    require_numbers(a, 3 * n);
    const std::size_t first = grid_.points.size();
    grid_.points.reserve(first + n);
    const auto check_from = [&](std::size_t i) {
      for (; i < grid_.points.size(); ++i)
        if (!is_finite(grid_.points[i])) fail_array(a, {"finite coordinates"}, {"others at point ", i - first});
    };
    if (a.type == vtk_number::float64 && !encoding_.compressed) {
      grid_.points.resize(first + n);
      read_array(a, 3 * n, grid_.points.data() + first);
      return check_from(first);
    }
    double x[3];
    unsigned k = 0;
    for_each_part<double>(a, 3 * n, [&](const double* values, std::size_t count) {
      const double* const end = values + count;
      const std::size_t before = grid_.points.size();
      const auto push_parts = [&](const double* last) {  // of a point that is in two parts of the array
        for (; values != last; ++values) {
          x[k++] = *values;
          if (k == 3) grid_.points.push_back({x[0], x[1], x[2]}), k = 0;
        }
      };
      push_parts(values + std::min<std::size_t>((3 - k) % 3, count));
      for (; end - values >= 3; values += 3) grid_.points.push_back({values[0], values[1], values[2]});
      push_parts(end);
      check_from(before);
    });
  }

  /// Checks a vert of a piece, and adds its number in the grid.
  void push_vert(const vtk_xml_array& a, std::size_t p, std::int64_t v) {
    if (v < 0 || static_cast<std::uint64_t>(v) >= index_.pieces[p].points)
      fail_array(a, {"point indices below ", index_.pieces[p].points}, {v});
    grid_.verts.push_back(vert_id{first_point_[p] + static_cast<std::size_t>(v)});
  }

  /// Adds n cells whose verts end where an array says, counted from those that the grid has. The ends do not decrease.
  /// Result: how many verts the cells have.
  std::uint32_t add_ends(const vtk_xml_array& a, std::uint64_t n) {
    require_numbers(a, n);
    std::vector<std::uint32_t>& ends = grid_.cell_ends;
    ends.reserve(ends.size() + n);
    const auto before = static_cast<std::uint32_t>(grid_.verts.size());
    std::int64_t last = 0;
    for_each_integers(a, n, [&](const std::int64_t* values, std::size_t count) {
      ends.resize(ends.size() + count);
      std::uint32_t* const to = ends.data() + (ends.size() - count);
      bool fits = values[0] >= last && values[count - 1] <= static_cast<std::int64_t>(max_ids);
      for (std::size_t i = 1; i < count; ++i) fits &= values[i] >= values[i - 1];
      for (std::size_t i = 0; !fits && i < count; last = values[i++])
        if (values[i] < last || values[i] > static_cast<std::int64_t>(max_ids))
          fail_array(a, {"ends that do not decrease"}, {values[i], " after ", last});
      for (std::size_t i = 0; i < count; ++i) to[i] = before + static_cast<std::uint32_t>(values[i]);
      last = values[count - 1];
    });
    return static_cast<std::uint32_t>(last);
  }

  /// Adds the n verts of the last cells. Those of polyhedra are only checked if the program reads volumes, as they are
  /// those of the faces, too.
  void add_verts(const vtk_xml_array& a, std::size_t p, std::uint32_t n, bool has_polyhedra = false) {
    if (grid_.verts.size() + n > max_ids) fail_to_count("corners");
    require_numbers(a, n);
    if (!has_polyhedra) grid_.verts.reserve(grid_.verts.size() + n);
    const std::uint64_t bound = index_.pieces[p].points;
    std::size_t cell = first_cell_[p], read = grid_.verts.size();  // the end of the verts that were read
    for_each_integers(a, n, [&](const std::int64_t* values, std::size_t count) {
      bool fits = true;
      for (std::size_t i = 0; i < count; ++i) fits &= static_cast<std::uint64_t>(values[i]) < bound;
      for (std::size_t i = 0; !fits && i < count; ++i) push_vert(a, p, values[i]);  // throws
      if (!has_polyhedra) return append_verts(values, count, first_point_[p]);
      for (const std::size_t end = read + count; read < end;) {
        const std::size_t cell_end = std::min<std::size_t>(grid_.cell_ends[cell], end);
        if (grid_.types[cell] != vtk_polyhedron) append_verts(values, cell_end - read, first_point_[p]);
        values += cell_end - read;
        read = cell_end;
        while (cell < grid_.size() && grid_.cell_ends[cell] <= read) ++cell;
      }
    });
  }

  void polydata_cells(std::size_t p, unsigned list) {
    const std::uint64_t n = index_.pieces[p].lists[list];
    if (n == 0) return;
    constexpr std::uint8_t types[] = {2, 4, 7, 6};
    const auto part = static_cast<vtk_xml_part>(list);
    if (n > max_ids || grid_.size() + n > max_ids) fail_to_count("cells");
    const std::uint32_t verts = add_ends(need(p, part, "offsets"), n);
    if (verts > 0) add_verts(need(p, part, "connectivity"), p, verts);
    const std::size_t first = grid_.types.size();
    grid_.types.resize(first + n);
    std::memset(grid_.types.data() + first, types[list], n);
  }

  void grid_cells(std::size_t p) {
    const std::uint64_t n = index_.pieces[p].cells;
    if (n == 0) return;
    if (n > max_ids || grid_.size() + n > max_ids) fail_to_count("cells");
    const vtk_xml_array& types = need(p, vtk_xml_part::cells, "types");
    const std::uint32_t verts = add_ends(need(p, vtk_xml_part::cells, "offsets"), n);
    require_numbers(types, n);
    grid_.types.reserve(grid_.types.size() + n);
    std::size_t num_polyhedra = 0;
    for_each_integers(types, n, [&](const std::int64_t* values, std::size_t count) {
      grid_.types.resize(grid_.types.size() + count);
      std::uint8_t* const to = grid_.types.data() + (grid_.types.size() - count);
      std::uint64_t all = 0, polyhedra_here = 0;
      for (std::size_t i = 0; i < count; ++i) {
        all |= static_cast<std::uint64_t>(values[i]);
        polyhedra_here += values[i] == vtk_polyhedron;
        to[i] = static_cast<std::uint8_t>(values[i]);
      }
      num_polyhedra += polyhedra_here;
      for (std::size_t i = 0; all > 255 && i < count; ++i)
        if (values[i] < 0 || values[i] > 255) fail_array(types, {"cell types from 0 to 255"}, {values[i]});
    });
    const std::size_t first = grid_.verts.size();
    if (verts > 0) add_verts(need(p, vtk_xml_part::cells, "connectivity"), p, verts, reads_polyhedra_ && num_polyhedra);
    if (num_polyhedra) polyhedra(p, first);
  }

 private:
  /// Appends verts of a piece, which have been checked.
  void append_verts(const std::int64_t* values, std::size_t count, std::uint64_t first) {
    grid_.verts.resize(grid_.verts.size() + count);
    vert_id* const to = grid_.verts.data() + (grid_.verts.size() - count);
    for (std::size_t i = 0; i < count; ++i)
      to[i] = vert_id{static_cast<std::uint32_t>(first + static_cast<std::uint64_t>(values[i]))};
  }
  /// Adds the faces of the polyhedra of a piece, if the program reads volumes; if not, that there are cells is an error
  /// later. The verts of its other cells begin at `first` in the grid.
  virtual void polyhedra(std::size_t, std::size_t /*first*/) {}
};

}  // namespace concino::detail
