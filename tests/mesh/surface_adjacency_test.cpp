#include <concino/mesh/surface_adjacency.hpp>

#include <concino/mesh/trimesh.hpp>

#include <support/kinds.hpp>
#include <support/rebuilt.hpp>

using namespace concino;
using namespace concino::testing;

namespace {

/// The tables of m, written by hand from its verbs.
surface_adjacency<3> tables_of(const trimesh& m) {
  surface_adjacency<3> a(num_verts(m), num_edges(m), num_polys(m));
  std::size_t corner = 0;
  for (const poly_id p : polys(m)) {
    for (unsigned k = 0; k < 3; ++k, ++corner) {
      const edge_id e = adj_p2e(m, p)[k];
      a.p2v[corner] = adj_p2v(m, p)[k];
      a.p2e[corner] = e;
      a.p2p[corner] = {};
      for (const poly_id q : adj_e2p(m, e))
        if (q != p) a.p2p[corner].raw = q.raw();
      if (*adj_e2p(m, e).begin() == p) a.first_corner[e.raw()] = static_cast<std::uint32_t>(corner);
    }
  }
  for (const edge_id e : edges(m))
    for (unsigned k = 0; k < 2; ++k) a.e2v[2 * e.raw() + k] = adj_e2v(m, e)[k];
  std::size_t edge = 0, poly = 0;
  a.first_poly.push_back(0);
  for (const vert_id v : verts(m)) {
    for (const vert_id w : adj_v2v(m, v)) a.v2v[edge++] = w;
    edge = a.first_edge[v.raw()];
    for (const edge_id e : adj_v2e(m, v)) a.v2e[edge++] = e;
    for (const poly_id p : adj_v2p(m, v)) a.v2p[poly++] = p;
    a.first_edge[v.raw() + 1] = static_cast<std::uint32_t>(edge);
    a.first_poly.push_back(static_cast<std::uint32_t>(poly));
  }
  if (a.first_poly == a.first_edge) a.first_poly.clear();
  return a;
}

}  // namespace

TEST_CASE("surface_adjacency: a mesh of finished tables is the mesh that they were taken from") {
  const auto check = [](const trimesh& m) {
    const trimesh same(m.points(), surface_tables<3>(tables_of(m)));
    CHECK(same.points() == m.points());
    has_same_adjacency(same, m);
    keeps_all_laws(same);
  };
  check(grid<trimesh>(3));
  check(trimesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {5, 5, 5}}, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}));  // closed, and a vert without triangles
  check(trimesh());
}
