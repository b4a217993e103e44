// Iterate over a mesh: `verts`, `edges` and `polys` list its elements; `adj_a2b` lists the elements b around one element a.
#include <concino/mesh.hpp>

#include <fmt/core.h>

namespace cn = concino;

int main() {
  // A roof over a square: two triangles and two quads.
  const cn::polygonmesh m({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 0.5, 1}, {1, 1.5, 1}},
                          {{0, 1, 4}, {1, 2, 5, 4}, {2, 3, 5}, {3, 0, 4, 5}});
  fmt::print("{} verts, {} edges, {} polys\n", cn::num_verts(m), cn::num_edges(m), cn::num_polys(m));

  for (cn::poly_id p : cn::polys(m)) {
    fmt::print("poly {} has verts", p.raw());
    for (cn::vert_id v : cn::adj_p2v(m, p)) fmt::print(" {}", v.raw());
    fmt::print(" and neighbours");
    for (cn::poly_id q : cn::adj_p2p(m, p)) fmt::print(" {}", q.raw());
    fmt::print("\n");
  }

  std::size_t border = 0;
  for (cn::edge_id e : cn::edges(m)) {
    std::size_t sides = 0;
    for ([[maybe_unused]] cn::poly_id p : cn::adj_e2p(m, e)) ++sides;
    if (sides == 1) ++border;
  }
  fmt::print("{} edges are on the boundary\n", border);

  // Values of elements are in a map outside the mesh, as here, or in a named property that the mesh stores.
  auto height = cn::make_vert_map<double>(m, 0.0);
  for (cn::vert_id v : cn::verts(m)) height[v] = cn::point(m, v)[2];
  fmt::print("vert 4 has height {}\n", height[cn::vert_id{4}]);
}
