// Construction of quadmesh; see quadmesh.hpp.
#pragma once

#include <concino/mesh/quadmesh.hpp>

#include <utility>

namespace concino {

CONCINO_INLINE quadmesh::quadmesh(surface_arrays a) : base(std::move(a.points), {}) {
  if (a.arity != 4) a = detail::to_arity(std::move(a), 4);
  tables() = surface_tables<4>(points().size(), std::move(a.verts));
}

CONCINO_INLINE quadmesh::quadmesh(point_list points, index_lists poly_verts)
    : quadmesh(detail::to_surface({points}, poly_verts, 4, "quadmesh")) {}

}  // namespace concino
