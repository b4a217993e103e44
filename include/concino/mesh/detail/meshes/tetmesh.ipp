// Construction of tetmesh; see tetmesh.hpp.
#pragma once

#include <concino/mesh/tetmesh.hpp>

#include <utility>

namespace concino {

CONCINO_INLINE tetmesh::tetmesh(cell_arrays a, tet_order order) : base(std::move(a.points), {}) {
  if (a.arity != 4)
    core::throw_joined<invalid_mesh>({"tetmesh: the arrays have polys of ", a.arity, " verts; it needs 4"});
  tables() = tet_tables(points().size(), std::move(a.verts), order);
}

CONCINO_INLINE tetmesh::tetmesh(point_list points, index_lists poly_verts, tet_order order)
    : tetmesh(detail::to_cells({points}, poly_verts, 4), order) {}

}  // namespace concino
