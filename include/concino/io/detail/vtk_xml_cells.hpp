// Reads the points and cells of the pieces of .vtu and .vtp files into a grid.
#pragma once

#include <concino/io/detail/corners.hpp>
#include <concino/io/detail/vtk_grid.hpp>
#include <concino/io/detail/vtk_xml_tags.hpp>
#include <concino/mesh/limits.hpp>

#include <cstring>

namespace concino::detail {

class vtk_xml_cells : public vtk_xml_data {
 protected:
  vtk_grid& grid_;
  vtk_xml_index index_;
  std::vector<std::size_t> first_point_, first_cell_;  // of each piece, and the end
  bool has_faces_ = false;                             // the grid has the faces of polyhedra instead of their verts

  vtk_xml_cells(const read_context& in, vtk_grid& grid) : vtk_xml_data(in), grid_(grid) {}
  ~vtk_xml_cells() = default;

  /// Null if there is none.
  const vtk_xml_array* find(std::size_t piece, vtk_xml_part part, std::string_view name) const {
    for (std::size_t i = index_.pieces[piece].first_entry; i < index_.entries.size() && index_.entries[i].piece == piece; ++i) {
      const vtk_xml_entry& e = index_.entries[i];
      if (e.part == part && (name.empty() || e.array.name == name)) return &e.array;
    }
    return nullptr;
  }
  const vtk_xml_array& need(std::size_t piece, vtk_xml_part part, std::string_view name) const {
    const vtk_xml_array* const a = find(piece, part, name);
    if (!a) fail(index_.pieces[piece].at, {"the array \"", name.empty() ? "Points" : name, "\""}, {"a piece without it"});
    return *a;
  }

  [[gnu::noinline]] void points(std::size_t p) {
    const std::uint64_t n = index_.pieces[p].points;
    if (n == 0) return;
    const vtk_xml_array& a = need(p, vtk_xml_part::points, "");
    if (a.components != 3) fail_array(a, {"three components"}, {a.components});
    if (n > max_ids || grid_.points.size() + n > max_ids) fail_to_count("points");
    require_numbers(a, 3 * n);
    const std::size_t first = grid_.points.size();
    if (a.type == vtk_number::float64) {
      grid_.points.resize(first + n);
      read_array(a, 3 * n, grid_.points.data() + first);
    } else {
      core::reserve_large(grid_.points, first + n);
      double x[3];
      unsigned k = 0;
      for_each_part<double>(a, 3 * n, [&](const double* values, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
          x[k++] = values[i];
          if (k == 3) grid_.points.push_back({x[0], x[1], x[2]}), k = 0;
        }
      });
    }
    for (std::size_t i = first; i < grid_.points.size(); ++i)
      if (!is_finite(grid_.points[i])) fail_array(a, {"finite coordinates"}, {"others at point ", i - first});
  }

  /// Checks a vert of a piece, and adds its number in the grid.
  void push_vert(const vtk_xml_array& a, std::size_t p, std::int64_t v) {
    if (v < 0 || static_cast<std::uint64_t>(v) >= index_.pieces[p].points) fail_array(a, {"point indices below ", index_.pieces[p].points}, {v});
    grid_.verts.push_back(vert_id{first_point_[p] + static_cast<std::size_t>(v)});
  }

  /// The ends of n lists, which do not decrease.
  std::vector<std::uint32_t> ends_of(const vtk_xml_array& a, std::uint64_t n) {
    require_numbers(a, n);
    std::vector<std::uint32_t> ends;
    core::reserve_large(ends, n);
    std::int64_t last = 0;
    for_each_integer(a, n, [&](std::int64_t e) {
      if (e < last || e > static_cast<std::int64_t>(max_ids)) fail_array(a, {"ends that do not decrease"}, {e, " after ", last});
      ends.push_back(static_cast<std::uint32_t>(last = e));
    });
    return ends;
  }

  /// Adds cells whose verts end at `ends` in the array.
  void lists(const vtk_xml_array& a, std::size_t p, const std::vector<std::uint32_t>& ends) {
    const std::uint64_t total = ends.empty() ? 0 : ends.back();
    if (grid_.verts.size() + total > max_ids) fail_to_count("corners");
    const auto before = static_cast<std::uint32_t>(grid_.verts.size());
    require_numbers(a, total);
    core::reserve_large(grid_.verts, grid_.verts.size() + total);
    const std::uint64_t bound = index_.pieces[p].points, first = first_point_[p];
    for_each_integers(a, total, [&](const std::int64_t* values, std::size_t count) {
      const std::size_t at_verts = grid_.verts.size();
      grid_.verts.resize(at_verts + count);
      vert_id* const to = grid_.verts.data() + at_verts;
      bool fits = true;
      for (std::size_t i = 0; i < count; ++i) {
        fits = fits && static_cast<std::uint64_t>(values[i]) < bound;
        to[i] = vert_id{static_cast<std::uint32_t>(first + static_cast<std::uint64_t>(values[i]))};
      }
      for (std::size_t i = 0; !fits && i < count; ++i) push_vert(a, p, values[i]);  // throws
    });
    core::reserve_large(grid_.cell_ends, grid_.cell_ends.size() + ends.size());
    for (const std::uint32_t e : ends) grid_.cell_ends.push_back(before + e);
  }

  /// Adds n cells without verts.
  void empty_lists(std::size_t n) {
    core::reserve_large(grid_.cell_ends, grid_.cell_ends.size() + n);
    for (std::size_t i = 0; i < n; ++i) grid_.cell_ends.push_back(static_cast<std::uint32_t>(grid_.verts.size()));
  }

  [[gnu::noinline, gnu::cold]] void polydata_cells(std::size_t p, unsigned list) {
    const std::uint64_t n = index_.pieces[p].lists[list];
    if (n == 0) return;
    constexpr std::uint8_t types[] = {2, 4, 6, 7};
    const auto part = static_cast<vtk_xml_part>(list);
    if (n > max_ids || grid_.size() + n > max_ids) fail_to_count("cells");
    const std::vector<std::uint32_t> ends = ends_of(need(p, part, "offsets"), n);
    if (!ends.empty() && ends.back() > 0) {
      lists(need(p, part, "connectivity"), p, ends);
    } else {
      empty_lists(ends.size());
    }
    const std::size_t first = grid_.types.size();
    grid_.types.resize(first + n);
    std::memset(grid_.types.data() + first, types[list], n);
  }

  [[gnu::noinline]] void grid_cells(std::size_t p) {
    const std::uint64_t n = index_.pieces[p].cells;
    if (n == 0) return;
    if (n > max_ids || grid_.size() + n > max_ids) fail_to_count("cells");
    const vtk_xml_array& types = need(p, vtk_xml_part::cells, "types");
    const std::vector<std::uint32_t> ends = ends_of(need(p, vtk_xml_part::cells, "offsets"), n);
    require_numbers(types, n);
    core::reserve_large(grid_.types, grid_.types.size() + n);
    bool any_polyhedron = false;
    for_each_integer(types, n, [&](std::int64_t t) {
      if (t < 0 || t > 255) fail_array(types, {"cell types from 0 to 255"}, {t});
      any_polyhedron = any_polyhedron || t == vtk_polyhedron;
      grid_.types.push_back(static_cast<std::uint8_t>(t));
    });
    const std::size_t first = grid_.verts.size();
    if (ends.back() > 0) lists(need(p, vtk_xml_part::cells, "connectivity"), p, ends);
    else empty_lists(ends.size());
    if (any_polyhedron) polyhedra(p, first, ends);
  }

 private:
  /// Replaces the verts of the polyhedra of a piece by their faces, if the program reads volumes; if not, that there are cells is an error later.
  /// The verts begin at `first` in the grid, and those of each cell end at `ends` behind that.
  virtual void polyhedra(std::size_t, std::size_t /*first*/, const std::vector<std::uint32_t>& /*ends*/) {}
};

}  // namespace concino::detail
