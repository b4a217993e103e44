// Writes volumes as .hedra.
#pragma once

#include <concino/io/detail/write_common.hpp>

namespace concino::detail {

template<class M>
void write_hedra(write_context<M>& c) {
  if constexpr (dimension_v<M> == 2) {  // the format holds volumes only
    c.cannot_hold(".hedra", {"surfaces"}, ".obj, or .mesh if it has triangles and quads only");
  } else {
    const M& m = c.mesh;
    c.out << num_verts(m) << ' ' << num_faces(m) << ' '
          << num_polys(m) << '\n';
    for (const vert_t<M> v : verts(m)) {
      write_point(c.out, c.next_point(v));
      c.out << '\n';
      c.tell();
    }
    std::vector<std::uint32_t> face_number(face_index_bound(m), 0);
    std::vector<std::uint32_t> row;
    std::uint32_t n = 0;
    for (face_t<M> f : faces(m)) {
      face_number[index_of(m, f)] = ++n;
      row.clear();
      for (vert_t<M> v : adj_f2v(m, f)) row.push_back(c.number_of(v));
      c.out << row.size();
      for (const std::uint32_t v : row) c.out << ' ' << v + 1;
      c.out << '\n';
    }
    std::vector<std::int64_t> signs;
    for (poly_t<M> p : polys(m)) {
      signs.clear();
      for (face_t<M> f : adj_p2f(m, p)) {
        const std::int64_t i = face_number[index_of(m, f)];
        signs.push_back(face_is_outward(m, p, f) ? i : -i);
      }
      c.out << signs.size();
      for (const std::int64_t f : signs) c.out << ' ' << f;
      c.out << '\n';
      c.tell();
    }
  }
}

}  // namespace concino::detail
