// Writes surfaces as Wavefront OBJ.
#pragma once

#include <concino/io/write_common.hpp>

namespace concino::detail {

template<class M>
void write_obj(write_context<M>& c) {
  if constexpr (dimension_v<M> == 3) {
    throw_cannot_hold(c.name, ".obj", "volumes", ".mesh or .hedra");
  } else {
    c.out << "# " << static_cast<std::size_t>(num_verts(c.mesh)) << " verts, " << static_cast<std::size_t>(num_polys(c.mesh)) << " polys\n";
    write_points(c, "v ", [](const auto&) {});
    for (poly_t<M> p : polys(c.mesh)) {
      c.out << 'f';
      for (vert_t<M> v : adj_p2v(c.mesh, p)) c.out << ' ' << c.number_of(v) + 1;
      c.out << '\n';
      c.tell();
    }
  }
}

}  // namespace concino::detail
