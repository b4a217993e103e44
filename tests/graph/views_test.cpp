// Graph algorithms give the same results on views as on their base meshes.
#include <concino/concepts/views.hpp>
#include <concino/graph/bfs.hpp>
#include <concino/graph/dijkstra.hpp>
#include <concino/mesh/boundary.hpp>
#include <concino/mesh/submesh.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

namespace cn = concino;

TEST_CASE_TEMPLATE("searches work on the primal and the dual view", M, cn::polygonmesh, cn::tetmesh) {
  const M m = cn::testing::grid<M>(3);
  const auto v0 = *cn::verts(m).begin();
  const auto p0 = *cn::polys(m).begin();
  const auto hops = cn::bfs(m, v0);
  const auto on_primal = cn::bfs(cn::primal(m), v0);
  const auto lengths = cn::dijkstra(m, v0);
  const auto primal_lengths = cn::dijkstra(cn::primal(m), v0);
  for (auto v : cn::verts(m)) {
    CHECK(on_primal[v] == hops[v]);
    CHECK(primal_lengths[v] == lengths[v]);
  }
  const auto dual_hops = cn::bfs(m, p0);
  const auto on_dual = cn::bfs(cn::dual(m), p0);
  const auto steps = cn::dijkstra(cn::dual(m), p0, [](auto, auto) { return 1.0; });
  for (auto p : cn::polys(m)) {
    CHECK(on_dual[p] == dual_hops[p]);
    CHECK(steps[p] == dual_hops[p]);
  }
}

TEST_CASE("with_points: lengths are distances between the points of the map") {
  const auto m = cn::testing::grid<cn::trimesh>(2);
  struct stretched {
    const cn::trimesh* m;
    cn::vec3 operator[](cn::vert_id v) const { return 3 * cn::to_vec3(cn::point(*m, v)); }
  };
  const auto d = cn::dijkstra(m, cn::vert_id{0});
  const auto far = cn::dijkstra(cn::with_points(m, stretched{&m}), cn::vert_id{0});
  for (auto v : cn::verts(m)) CHECK(far[v] == doctest::Approx(3 * d[v]));
}

TEST_CASE("bfs: reaches exactly the elements of a boundary view and of a submesh") {
  const auto m = cn::testing::grid<cn::hexmesh>(3);
  const auto skin = cn::boundary(m);
  const auto on_skin = cn::bfs(skin, cn::vert_id{0});
  for (auto v : cn::verts(m)) CHECK((on_skin[v] >= 0) == cn::contains(skin, v));
  const auto layer = cn::submesh(m, [&](auto p) { return cn::index_of(m, p) < 9; });
  const auto within = cn::bfs(layer, cn::poly_id{0});
  for (auto p : cn::polys(m)) CHECK((within[p] >= 0) == (p.raw() < 9));
}
