// Construction of polygonmesh; see polygonmesh.hpp.
#pragma once

#include <concino/mesh/polygonmesh.hpp>

#include <utility>

namespace concino {

CONCINO_INLINE polygonmesh::polygonmesh() : polygonmesh(surface_arrays{}) {}

CONCINO_INLINE polygonmesh::polygonmesh(surface_arrays a) : base(std::move(a.points), {}) {
  if (a.arity) a = detail::to_arity(std::move(a), 0);
  tables() = surface_tables<0>(points().size(), std::move(a.offsets), std::move(a.verts));
}

CONCINO_INLINE polygonmesh::polygonmesh(point_list points, index_lists poly_verts)
    : polygonmesh(detail::to_surface({points}, poly_verts, 0, "polygonmesh")) {}

}  // namespace concino
