// Bodies of joined_grid.hpp: joins the grids of the pieces of a .pvtu file into one.
#pragma once

#include <concino/io/detail/pvtu/joined_grid.hpp>
#include <concino/io/detail/vtk/vtk_numbers.hpp>
#include <concino/io/detail/vtk_xml/vtk_united_points.hpp>
#include <concino/mesh/support/limits.hpp>

#include <algorithm>
#include <cstring>
#include <utility>

namespace concino::detail {

CONCINO_INLINE void joined_grid::skip(const std::string& array, const char* why) {
  const std::size_t known = reported_.size();
  if (reported_.add(array) == known) report_.skipped.push_back(core::joined({"array \"", array, "\", ", why}));
}

/// Adds the values of `count` elements to those of `before` elements.
CONCINO_INLINE void joined_grid::add_columns(vtk_grid& part, element_kind kind, std::size_t before,
                                             std::size_t count) {
  if (count == 0) return;
  const auto same = [kind](std::vector<property_column>& all, const property_column& c) {
    return std::find_if(all.begin(), all.end(), [&](const property_column& x) {
      return x.kind == kind && x.name == c.name && x.values->type() == c.values->type();
    });
  };
  for (property_column& c : part.columns) {
    if (c.kind != kind || same(grid.columns, c) != grid.columns.end()) continue;
    if (before == 0) grid.columns.push_back({kind, c.name, make_column(c.values->operations(), 0)});
    else if (kind != element_kind::mesh) skip(c.name, "which other pieces lack or have with other types");
  }
  for (std::size_t i = 0; i < grid.columns.size(); ++i) {
    property_column& c = grid.columns[i];
    if (c.kind != kind || (kind == element_kind::mesh && before > 0)) continue;
    const auto from = same(part.columns, c);
    if (from == part.columns.end()) {
      skip(c.name, "which other pieces lack or have with other types");
      grid.columns.erase(grid.columns.begin() + static_cast<std::ptrdiff_t>(i--));
      continue;
    }
    if (before == 0) {
      c.values = std::move(from->values);
      from->values = make_column(c.values->operations(), 0);
      continue;
    }
    const std::size_t size = c.values->operations().size;
    c.values->resize(before + count);
    std::memcpy(static_cast<unsigned char*>(c.values->data()) + before * size, from->values->data(), count * size);
  }
}

CONCINO_INLINE void joined_grid::add(vtk_grid&& part, const std::string& path, std::size_t line) {
  const std::size_t first_point = grid.points.size(), first_cell = grid.size(), first_vert = grid.verts.size();
  const auto check = [&](std::uint64_t n, const char* what) {
    if (n > max_ids) core::throw_joined<unsupported>({path, ": more than ", max_ids, what, " in all pieces"});
  };
  check(std::uint64_t{first_point} + part.points.size(), " points");
  check(std::uint64_t{first_cell} + part.size(), " cells");
  check(std::uint64_t{first_vert} + part.verts.size(), " corners");
  add_columns(part, element_kind::vert, first_point, part.points.size());
  add_columns(part, element_kind::poly, first_cell, part.size());
  add_columns(part, element_kind::mesh, pieces_.size(), 1);
  pieces_.push_back({path, line, first_point, first_cell, part.num_ghosts > 0});
  for (std::size_t c = 0; c < part.size() && first_point > 0; ++c)
    for_each_vert_of(part, c, has_faces_, [&](vert_id& v) { v = vert_id{first_point + v.raw()}; });
  for (const std::uint32_t end : part.cell_ends)
    grid.cell_ends.push_back(static_cast<std::uint32_t>(first_vert + end));
  grid.points.insert(grid.points.end(), part.points.begin(), part.points.end());
  grid.verts.insert(grid.verts.end(), part.verts.begin(), part.verts.end());
  grid.types.insert(grid.types.end(), part.types.begin(), part.types.end());
  grid.num_ghosts += part.num_ghosts;
}

CONCINO_INLINE const joined_grid::piece& joined_grid::piece_of_cell(std::size_t cell) const {
  std::size_t p = pieces_.size() - 1;
  while (p > 0 && pieces_[p].first_cell > cell) --p;
  return pieces_[p];
}
CONCINO_INLINE const joined_grid::piece& joined_grid::piece_of_point(std::size_t point) const {
  std::size_t p = pieces_.size() - 1;
  while (p > 0 && pieces_[p].first_point > point) --p;
  return pieces_[p];
}

CONCINO_INLINE void joined_grid::fail_at_cell(std::size_t cell, core::message expected, core::message found) {
  if (!order_.empty()) cell = order_[cell];
  const piece& p = piece_of_cell(cell);
  throw parse_error(p.path, p.line, core::joined(expected),
                    core::joined({core::joined(found), " in cell ", cell - p.first_cell, " of the piece",
                                  p.has_ghosts ? ", not counting ghosts" : ""}));
}
CONCINO_INLINE std::string joined_grid::place_of_cell(std::size_t cell) {
  if (!order_.empty()) cell = order_[cell];
  const piece& p = piece_of_cell(cell);
  return core::joined({"position ", cell - p.first_cell, " of the piece ", p.path});
}

/// The numbers of elements, from an array of integers; empty if there is no such array.
CONCINO_INLINE std::vector<std::int64_t> joined_grid::ids(element_kind kind, const std::string& array) const {
  for (const property_column& c : grid.columns) {
    const vtk_property_type type = vtk_type_of(c.values->type());
    if (c.kind != kind || c.name != array || type.components != 1 || type.number >= vtk_number::float32) continue;
    std::vector<std::int64_t> all(c.values->size());
    with_number_type(type.number, [&]<class T>(std::type_identity<T>) {
      const T* const values = static_cast<const T*>(c.values->data());
      for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::int64_t>(values[i]);
    });
    return all;
  }
  return {};
}

/// The positions of numbers, in increasing order.
inline std::vector<std::uint32_t> sorted_positions(const std::vector<std::int64_t>& ids) {
  std::vector<std::uint32_t> order(ids.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::uint32_t>(i);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return ids[a] != ids[b] ? ids[a] < ids[b] : a < b; });
  return order;
}

CONCINO_INLINE void joined_grid::unite_by_ids(const std::vector<std::int64_t>& ids, const std::string& array) {
  const std::vector<std::uint32_t> order = sorted_positions(ids);
  const vtk_point_values values(grid);
  std::vector<std::uint32_t> number(ids.size()), kept;
  std::uint64_t num_different = 0;
  const std::string* different = nullptr;
  for (const std::uint32_t i : order) {
    if (kept.empty() || ids[kept.back()] != ids[i]) {
      kept.push_back(i);
    } else if (!(grid.points[i] == grid.points[kept.back()])) {
      const piece& p = piece_of_point(i);
      throw parse_error(p.path, p.line,
                        core::joined({"the point of number ", ids[i], " in the array \"", array, "\" where the piece ",
                                      piece_of_point(kept.back()).path, " has it"}),
                        core::joined({"another place, of point ", i - p.first_point, " of the piece"}));
    } else if (const std::string* const other = values.different_array(kept.back(), i)) {
      ++num_different;
      if (!different) different = other;
    }
    number[i] = static_cast<std::uint32_t>(kept.size() - 1);
  }
  report_.notes.push_back(core::joined({pieces_.size(), " pieces were joined: ", ids.size() - kept.size(),
                                        " points of the same number in the array \"", array, "\" became one"}));
  if (num_different)
    report_.notes.push_back(core::joined({num_different, " of them have other values than in an earlier piece, the "
                                                         "first one in \"", *different, "\": those of the earlier one "
                                                         "were taken"}));
  renumber_points(grid, number, kept, has_faces_);
}

CONCINO_INLINE void joined_grid::sort_cells(const std::vector<std::int64_t>& ids, const std::string& array) {
  const auto is_cell = [&](std::uint8_t type) { return kind_of_vtk_cell(type) == vtk_kind::cell; };
  const bool is_volume = std::any_of(grid.types.begin(), grid.types.end(), is_cell);
  std::vector<std::uint32_t> order = sorted_positions(ids);
  // polygons of a volume are faces with values, which have no numbers, and stay behind the cells
  if (is_volume)
    std::stable_partition(order.begin(), order.end(), [&](std::uint32_t c) { return is_cell(grid.types[c]); });
  for (std::size_t k = 1; k < order.size() && (!is_volume || is_cell(grid.types[order[k]])); ++k)
    if (const std::uint32_t a = order[k - 1], b = order[k]; ids[a] == ids[b])
      throw parse_error(piece_of_cell(b).path, piece_of_cell(b).line,
                        core::joined({"cells of different numbers in the array \"", array, "\", but for ghosts"}),
                        core::joined({ids[b], ", which ", piece_of_cell(a).path, " has, too"}));
  if (std::is_sorted(order.begin(), order.end())) return;
  vtk_grid sorted;
  for (const std::uint32_t c : order) {
    sorted.types.push_back(grid.types[c]);
    sorted.verts.insert(sorted.verts.end(), grid.verts.begin() + static_cast<std::ptrdiff_t>(grid.first(c)),
                        grid.verts.begin() + static_cast<std::ptrdiff_t>(grid.cell_ends[c]));
    sorted.cell_ends.push_back(static_cast<std::uint32_t>(sorted.verts.size()));
  }
  grid.types = std::move(sorted.types);
  grid.verts = std::move(sorted.verts);
  grid.cell_ends = std::move(sorted.cell_ends);
  keep_grid_values(grid, element_kind::poly, order);
  order_ = std::move(order);
}

CONCINO_INLINE void joined_grid::finish(const std::string& point_ids, const std::string& cell_ids) {
  if (const std::vector<std::int64_t> of_points = ids(element_kind::vert, point_ids); !of_points.empty()) {
    unite_by_ids(of_points, point_ids);
  } else if (pieces_.size() > 1) {
    std::vector<std::size_t> first_point;
    for (const piece& p : pieces_) first_point.push_back(p.first_point);
    first_point.push_back(grid.points.size());
    unite_points_of_pieces(grid, vtk_point_merger(grid, first_point), has_faces_, pieces_.size(), report_);
  }
  if (const std::vector<std::int64_t> of_cells = ids(element_kind::poly, cell_ids); !of_cells.empty())
    sort_cells(of_cells, cell_ids);
  if (!grid.points.empty()) grid.largest = static_cast<std::uint32_t>(grid.points.size() - 1);
}

}  // namespace concino::detail
