// Construction of hexmesh; see hexmesh.hpp.
#pragma once

#include <concino/mesh/hexmesh.hpp>

#include <utility>

namespace concino {

CONCINO_INLINE hexmesh::hexmesh(cell_arrays a, hex_order order) : base(std::move(a.points), {}) {
  if (a.arity != 8)
    core::throw_joined<invalid_mesh>({"hexmesh: the arrays have polys of ", a.arity, " verts; it needs 8"});
  tables() = hex_tables(points().size(), std::move(a.verts), order);
}

CONCINO_INLINE hexmesh::hexmesh(point_list points, index_lists poly_verts, hex_order order)
    : hexmesh(detail::to_cells({points}, poly_verts, 8), order) {}

}  // namespace concino
