// An edge of a volume, or a diagonal of a face, that a line has reached.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/oriented_edges.hpp>
#include <concino/lines/detail/cells/polyhedron_reader.hpp>
#include <concino/lines/detail/cells/volume_exits.hpp>

#include <algorithm>
#include <optional>

namespace concino::detail {

template<class M>
struct line_ridge {
  vert_t<M> from, to;
  vec3 from_point, to_point;
  std::optional<edge_t<M>> edge;
  std::optional<face_t<M>> face;  // of a diagonal
  incident_key key;
};

template<class M>
line_ridge<M> ridge_of(const M& m, const edge_t<M>& e) {
  const auto [a, b] = end_verts(m, e);
  return {a, b, to_vec3(point(m, a)), to_vec3(point(m, b)), e, {}, {index_of(m, e), SIZE_MAX}};
}

/// Side k of a triangle of the cell that was read last.
template<class M>
line_ridge<M> ridge_of(const M& m, const polyhedron_reader<M>& cell, const cell_triangle& t, std::uint32_t k) {
  const std::uint32_t a = t.corner[k], b = t.corner[(k + 1) % 3];
  const face_t<M> f = cell.faces[t.face];
  line_ridge<M> r = {cell.verts[a], cell.verts[b], cell.flat.points[a], cell.flat.points[b], {}, {}, {}};
  if (t.is_diagonal(k)) {
    const std::size_t i = t.ring[k], j = t.ring[(k + 1) % 3];
    r.face = f;
    r.key = {edge_index_bound(m) + index_of(m, f), std::min(i, j) * t.ring_size + std::max(i, j)};
    return r;
  }
  for (const auto& [e, from, to] : oriented_edges(m, f))
    if ((from == r.from && to == r.to) || (from == r.to && to == r.from)) {
      r.edge = e;
      r.key = {index_of(m, e), SIZE_MAX};
      break;
    }
  return r;
}

}  // namespace concino::detail
