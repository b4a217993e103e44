// Construction of polyhedralmesh; see polyhedralmesh.hpp.
#pragma once

#include <concino/mesh/polyhedralmesh.hpp>

#include <utility>

namespace concino {

CONCINO_INLINE polyhedralmesh::polyhedralmesh() : polyhedralmesh(polyhedra_arrays{}) {}

CONCINO_INLINE polyhedralmesh::polyhedralmesh(polyhedra_arrays a) : base(std::move(a.points), {}) {
  tables() = polyhedra_tables(points().size(), std::move(a.face_offsets), std::move(a.face_verts),
                              std::move(a.poly_offsets), std::move(a.poly_faces), std::move(a.outward));
}

CONCINO_INLINE polyhedralmesh::polyhedralmesh(point_list points, index_lists face_verts, face_lists poly_faces)
    : polyhedralmesh(detail::polyhedra_arrays_from({points}, face_verts, poly_faces)) {}

}  // namespace concino
