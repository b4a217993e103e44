// The writer of .hedra, Cinolib's format for volumes of any polyhedra.
#pragma once

#include <concino/io/detail/hedra/hedra_format.hpp>
#include <concino/io/detail/text/write_common.hpp>

namespace concino::detail {

}  // namespace concino::detail

namespace concino {

inline void hedra_format::write(write_context& c, flat_mesh& m) {
  const flat_polyhedra& all = m.polyhedra();
  c.out << m.points.size() << ' ' << all.face_verts.size() << ' ' << m.num_polys << '\n';
  for (const vec3& p : m.points) {
    detail::write_point(c.out, p);
    c.out << '\n';
    c.report_progress();
  }
  for (std::size_t f = 0; f < all.face_verts.size(); ++f) {
    const std::span<const vert_id> corners = all.face_verts[f];
    c.out << corners.size();
    for (const vert_id v : corners) c.out << ' ' << v.raw() + 1;
    c.out << '\n';
  }
  const std::uint8_t* outward = all.outward.data();
  for (std::size_t p = 0; p < m.num_polys; ++p) {
    const std::span<const face_id> faces_of_poly = all.poly_faces[p];
    c.out << faces_of_poly.size();
    for (const face_id f : faces_of_poly) {
      const std::int64_t i = std::int64_t{f.raw()} + 1;
      c.out << ' ' << (*outward++ != 0 ? i : -i);
    }
    c.out << '\n';
    c.report_progress();
  }
}

}  // namespace concino
