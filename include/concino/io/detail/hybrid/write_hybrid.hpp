// The writer of .hybrid, the format of hex-dominant meshes.
#pragma once

#include <concino/io/detail/cells/recognised_cells.hpp>
#include <concino/io/detail/hybrid/hybrid_format.hpp>
#include <concino/io/detail/text/write_common.hpp>

namespace concino::detail {

/// Writes a list of numbers, after their count.
template<class R, class Number>
void write_list(text_sink& out, const R& list, const Number& number) {
  out << list.size();
  for (const auto x : list) out << ' ' << number(x);
  out << '\n';
}

}  // namespace concino::detail

namespace concino {

inline void hybrid_format::write(write_context& c, flat_mesh& m) {
  const flat_polyhedra& all = m.polyhedra();
  const auto number = [](auto x) { return x.raw(); };
  c.out << m.points.size() << ' ' << all.face_verts.size() << ' ' << 3 * m.num_polys << '\n';
  for (const vec3& p : m.points) {
    detail::write_point(c.out, p);
    c.out << '\n';
    c.report_progress();
  }
  for (std::size_t f = 0; f < all.face_verts.size(); ++f) detail::write_list(c.out, all.face_verts[f], number);
  std::size_t first = 0;
  for (std::size_t p = 0; p < m.num_polys; ++p) {
    const std::span<const face_id> faces_of_poly = all.poly_faces[p];
    detail::write_list(c.out, faces_of_poly, number);
    detail::write_list(c.out, all.outward.subspan(first, faces_of_poly.size()),
                       [](std::uint8_t outward) { return outward != 0 ? 1 : 0; });
    first += faces_of_poly.size();
    c.report_progress();
  }
  cell_recogniser known;
  first = 0;
  for (std::size_t p = 0; p < m.num_polys; ++p) {
    const bool is_hex = all.poly_faces[p].size() == 6 && detail::recognise(all, p, first, known) == cell_shape::hex;
    c.out << (is_hex ? 1 : 0) << '\n';
    first += all.poly_faces[p].size();
  }
}

}  // namespace concino
