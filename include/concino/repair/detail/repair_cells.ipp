// Bodies of repair_cells.hpp. A cell is a list of verts, as polygons are.
#pragma once

#include <concino/core/message.hpp>
#include <concino/mesh/support/face_merger.hpp>
#include <concino/mesh/support/standard_cells.hpp>
#include <concino/repair/detail/cell_windings.hpp>
#include <concino/repair/detail/repair_cells.hpp>
#include <concino/repair/detail/surface_steps.hpp>

#include <algorithm>
#include <numeric>

namespace concino::detail {

/// Tets with a vert twice have no volume.
/// Errors: unsupported for other cells.
inline void remove_cells_with_repeated_verts(surface_lists& s, std::uint32_t arity, repair_log& log) {
  std::vector<std::uint8_t> marked(s.num_polys());
  std::vector<std::uint32_t> list;
  bool any = false;
  for (std::size_t p = 0; p < s.num_polys(); ++p) {
    list.assign(s.poly(p).begin(), s.poly(p).end());
    std::sort(list.begin(), list.end());
    if (std::adjacent_find(list.begin(), list.end()) == list.end()) continue;
    if (arity != 4)
      core::throw_joined<unsupported>({"repair: poly ", log.poly_index()[s.poly_origin[p]],
                                       " would be no hex any more, as verts of it are merged; convert the mesh to a "
                                       "polyhedralmesh first"});
    marked[p] = 1;
    any = true;
    log.add(repair_kind::removed_degenerate, s.poly_origin[p]);
  }
  if (any) s.remove(marked);
}

/// Turns inverted cells, and those that are wound unlike their neighbours.
inline void turn_cells(surface_lists& s, cell_shape shape, repair_log& log) {
  const standard_cell& cell = standard_cell_of(shape);
  face_merger merger(s.points.size());
  polyhedra_arrays merged;
  cell_faces cells;
  std::vector<std::int8_t> sign;
  vert_id corners[8], face[4];
  for (std::size_t p = 0; p < s.num_polys(); ++p) {
    const auto list = s.poly(p);
    bool is_known = true;
    for (std::size_t k = 0; k < list.size(); ++k) {
      corners[k] = vert_id{list[k]};
      is_known = is_known && is_finite(s.points[list[k]]);
    }
    for (unsigned f = 0; f < cell.num_faces; ++f) {
      for (unsigned k = 0; k < cell.face_size[f]; ++k) face[k] = corners[cell.face_vert[f][k]];
      const auto at = merger.add(face, cell.face_size[f]);
      merged.poly_faces.push_back(at.face);
      merged.outward.push_back(at.order > 0);
    }
    cells.offsets.push_back(static_cast<std::uint32_t>(merged.poly_faces.size()));
    if (!is_known) sign.push_back(0);
    else if (has_negative_volume(shape, corners, s.points)) sign.push_back(-1);
    else {
      vert_id mirrored[8];
      for (unsigned k = 0; k < cell.num_verts; ++k) mirrored[k] = corners[cell.mirrored[k]];
      sign.push_back(has_negative_volume(shape, mirrored, s.points) ? 1 : 0);
    }
  }
  merger.finish(merged);
  cells.num_faces = merged.num_faces();
  cells.outward = std::move(merged.outward);
  for (const face_id f : merged.poly_faces) cells.faces.push_back(f.raw());
  const std::vector<std::uint8_t> turns = cells_to_turn(cells, sign, s.poly_origin, log);
  for (std::size_t p = 0; p < turns.size(); ++p) {
    if (!turns[p]) continue;
    const auto list = s.poly(p);
    const std::vector<std::uint32_t> was(list.begin(), list.end());
    for (std::size_t k = 0; k < was.size(); ++k) list[k] = was[cell.mirrored[k]];
  }
}

CONCINO_INLINE repaired_arrays<cell_arrays> repair_cells(cell_arrays a, const repair_options& options,
                                                         repair_log& log) {
  const std::uint32_t arity = a.arity;
  surface_arrays lists{std::move(a.points), {}, std::move(a.verts), 0};
  for (std::size_t i = 0; i <= lists.verts.size(); i += arity) lists.offsets.push_back(static_cast<std::uint32_t>(i));
  surface_lists s = lists_of(std::move(lists));
  if (options.merge_within) merge_verts_within(s, *options.merge_within, log);
  remove_cells_with_repeated_verts(s, arity, log);
  if (options.remove_duplicates) remove_duplicate_polys(s, log);
  report_progress(options.progress, 0.4, "repair");
  if (options.turn_inverted) turn_cells(s, arity == 4 ? cell_shape::tet : cell_shape::hex, log);
  repaired_arrays<surface_arrays> r = arrays_of_lists(std::move(s), arity, options.remove_unreferenced, log);
  return {{std::move(r.arrays.points), std::move(r.arrays.verts), arity},
          std::move(r.verts),
          std::move(r.polys),
          std::move(r.cluster)};
}

}  // namespace concino::detail
