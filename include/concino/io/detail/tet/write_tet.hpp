// The writer of .tet: tets in the form that Cinolib and geogram read; meshes that also have other cells in that of
// geogram.
#pragma once

#include <concino/io/detail/cells/recognised_cells.hpp>
#include <concino/io/detail/cells/voxel_order.hpp>
#include <concino/io/detail/tet/tet_format.hpp>
#include <concino/io/detail/text/write_common.hpp>

namespace concino {

inline void tet_format::write(write_context& c, flat_mesh& m) {
  bool only_tets = true;
  detail::hex_order_vote vote;  // of readers that do not see the comment
  detail::for_each_cell(m, [&](std::size_t p, cell_shape s, const vert_id* v) {
    if (s == cell_shape::general) detail::throw_general_cell(c, m, p, ".tet");
    if (s == cell_shape::hex) vote.add(detail::swap_voxel_order(v).data(), m.points);
    only_tets = only_tets && s == cell_shape::tet;
  });
  c.out << m.points.size() << " vertices\n" << m.num_polys << (only_tets ? " tets\n" : " cells\n");
  for (const vec3& p : m.points) {
    detail::write_point(c.out, p);
    c.out << '\n';
    c.report_progress();
  }
  if (vote.is_standard()) c.out << detail::voxel_order_comment << '\n';
  detail::for_each_cell(m, [&](std::size_t, cell_shape s, const vert_id* v) {
    const unsigned n = standard_cell_of(s).num_verts;
    c.out << n;
    for (unsigned k = 0; k < n; ++k) c.out << ' ' << v[s == cell_shape::hex ? detail::voxel_order[k] : k].raw();
    c.out << '\n';
    c.report_progress();
  });
}

}  // namespace concino
