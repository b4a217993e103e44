// Polys of a proposed edit as meshes; see proposed_mesh.hpp.
#pragma once

#include <concino/edit/detail/proposed_mesh.hpp>

#include <algorithm>

namespace concino::detail {

CONCINO_INLINE polygonmesh new_polygon(const proposed_edit& e, std::size_t k) {
  surface_arrays a;
  a.offsets.push_back(0);
  for (const unsigned v : e.new_poly(k)) {
    a.verts.push_back(vert_id{a.points.size()});
    a.points.push_back(e.points_after[v]);
  }
  a.offsets.push_back(static_cast<std::uint32_t>(a.verts.size()));
  return polygonmesh(std::move(a));
}

CONCINO_INLINE polyhedralmesh new_polyhedron(const proposed_edit& e, std::size_t k) {
  polyhedra_arrays a;
  a.face_offsets.push_back(0), a.poly_offsets.push_back(0);
  std::vector<unsigned> verts;  // sorted
  for (const unsigned v : e.new_poly(k)) verts.push_back(v);
  std::sort(verts.begin(), verts.end());
  verts.erase(std::unique(verts.begin(), verts.end()), verts.end());
  for (const unsigned v : verts) a.points.push_back(e.points_after[v]);
  const auto add_face = [&](const auto& corners) {
    for (const unsigned v : corners)
      a.face_verts.push_back(vert_id{std::lower_bound(verts.begin(), verts.end(), v) - verts.begin()});
    a.face_offsets.push_back(static_cast<std::uint32_t>(a.face_verts.size()));
    a.poly_faces.push_back(face_id{a.poly_faces.size()});
    a.outward.push_back(1);
  };
  if (e.corners_per_poly == 4) {
    const auto c = e.new_poly(k);
    for (const auto& f : {std::array{0, 2, 1}, std::array{0, 1, 3}, std::array{1, 2, 3}, std::array{0, 3, 2}})
      add_face(std::array{c[static_cast<std::size_t>(f[0])], c[static_cast<std::size_t>(f[1])],
                          c[static_cast<std::size_t>(f[2])]});
  } else {
    const proposed_lists faces = e.new_lists(k);
    for (std::size_t i = 0; i < faces.size(); ++i) add_face(faces[i]);
  }
  a.poly_offsets.push_back(static_cast<std::uint32_t>(a.poly_faces.size()));
  return polyhedralmesh(std::move(a));
}

}  // namespace concino::detail
