// Unites the points of the pieces of a grid of VTK that are one point.
#pragma once

#include <concino/io/detail/vtk_xml/vtk_pieces.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

namespace concino::detail {

/// Keeps only these values of the columns of a kind, in this order.
inline void keep_grid_values(vtk_grid& grid, element_kind kind, const std::vector<std::uint32_t>& kept) {
  const bool in_place = std::is_sorted(kept.begin(), kept.end());  // no value is overwritten before it is read
  std::vector<unsigned char> copy;
  for (property_column& c : grid.columns) {
    if (c.kind != kind) continue;
    const std::size_t size = c.values->operations().size;
    auto* const to = static_cast<unsigned char*>(c.values->data());
    if (!in_place) copy.assign(to, to + c.values->size() * size);
    const unsigned char* const from = in_place ? to : copy.data();
    for (std::size_t i = 0; i < kept.size(); ++i)
      if (from + kept[i] * size != to + i * size) std::memcpy(to + i * size, from + kept[i] * size, size);
    c.values->resize(kept.size());
  }
}

/// Calls f(vert) for each vert in the list of a cell, which may change it. has_faces: those of polyhedra are the lists
/// of their faces.
template<class F>
void for_each_vert_of(vtk_grid& grid, std::size_t cell, bool has_faces, const F& f) {
  const std::size_t end = grid.cell_ends[cell];
  std::size_t i = grid.first(cell);
  if (grid.types[cell] != vtk_polyhedron || !has_faces) {
    for (; i < end; ++i) f(grid.verts[i]);
    return;
  }
  for (++i; i < end;) {
    const std::size_t face_end = i + 1 + grid.verts[i].raw();
    for (++i; i < face_end; ++i) f(grid.verts[i]);
  }
}

/// Gives the verts of all cells their new numbers. Only the points in `kept` stay, with their values.
inline void renumber_points(vtk_grid& grid, const std::vector<std::uint32_t>& number,
                            const std::vector<std::uint32_t>& kept, bool has_faces) {
  for (std::size_t c = 0; c < grid.size(); ++c)
    for_each_vert_of(grid, c, has_faces, [&](vert_id& v) { v = vert_id{number[v.raw()]}; });
  keep_grid_values(grid, element_kind::vert, kept);
  std::vector<vec3> points;
  points.reserve(kept.size());
  for (const std::uint32_t i : kept) points.push_back(grid.points[i]);
  grid.points = std::move(points);
}

/// Gives points of different pieces at the same place, with the same values, one number. Reports how many.
inline void unite_points_of_pieces(vtk_grid& grid, const vtk_point_merger& merged, bool has_faces,
                                   std::size_t num_pieces, load_report& report) {
  const std::size_t n = grid.points.size();
  constexpr const char* where = " points at the place of a point of an earlier piece ";
  report.notes.push_back(
      core::joined({num_pieces, " pieces were joined: ", n - merged.kept.size(), where, "became that point"}));
  if (merged.num_different)
    report.notes.push_back(
        core::joined({merged.num_different, where, "stayed apart: they have other values, the first one in \"",
                      *merged.different, "\""}));
  if (merged.num_coincident)
    report.notes.push_back(
        core::joined({merged.num_coincident, where, "stayed apart: a piece has several points there"}));
  if (merged.kept.size() < n) renumber_points(grid, merged.number, merged.kept, has_faces);
}

}  // namespace concino::detail
