// Construction of trimesh; see trimesh.hpp.
#pragma once

#include <concino/mesh/trimesh.hpp>

#include <utility>

namespace concino {

CONCINO_INLINE trimesh::trimesh(surface_arrays a) : base(std::move(a.points), {}) {
  if (a.arity != 3) a = detail::to_arity(std::move(a), 3);
  tables() = surface_tables<3>(points().size(), std::move(a.verts));
}

CONCINO_INLINE trimesh::trimesh(point_list points, index_lists poly_verts)
    : trimesh(detail::to_surface({points}, poly_verts, 3, "trimesh")) {}

}  // namespace concino
