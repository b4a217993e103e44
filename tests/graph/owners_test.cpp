// Every graph algorithm runs on the archetype of its concept that owns its elements and can be neither copied nor moved.
#include <concino/concepts/archetypes.hpp>
#include <concino/graph.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr auto one = [](const auto&, const auto&) { return 1.0; };

}  // namespace

TEST_CASE_TEMPLATE("graphs: algorithms run on archetypes that can be neither copied nor moved", M, trimesh, polyhedralmesh) {
  const M m = grid<M>(2);
  const archetypes::owner<decltype(only_primal_graph(m))> g(m);
  const auto v = g.vert(vert_id{0}), w = g.vert(vert_id{static_cast<unsigned>(num_verts(m) - 1)});
  CHECK(bfs(g, v)[w] == bfs(m, vert_id{0})[g.base(w)]);
  CHECK(dijkstra(g, {v}, one, {.targets = {w}})[w] == bfs(m, vert_id{0})[g.base(w)]);
  CHECK(shortest_path(g, v, w, one).size() == static_cast<std::size_t>(bfs(g, v)[w]) + 1);
  CHECK(connected_components(g).count == 1);
  CHECK(spanning_tree(g, one).arcs.size() == num_verts(m) - 1);
  CHECK(grow_regions(g, {v, w}, one)[w] == 1);

  const archetypes::owner<decltype(only_dual_graph(m))> d(m);
  const auto p = d.poly(poly_id{0}), q = d.poly(poly_id{static_cast<unsigned>(num_polys(m) - 1)});
  auto from = make_poly_map<std::remove_const_t<decltype(p)>>(d, p);
  CHECK(bfs(d, p, {.predecessors = &from})[q] == bfs(m, poly_id{0})[d.base(q)]);
  CHECK(path_to(from, q).size() == static_cast<std::size_t>(bfs(d, p)[q]) + 1);
  CHECK(dijkstra(d, p, one)[q] == bfs(d, p)[q]);
  CHECK(connected_components(dual(d)).count == 1);
  CHECK(spanning_tree(dual(d), one, {.method = tree_method::prim}).arcs.size() == num_polys(m) - 1);
  CHECK(grow_regions(d, p, one)[q] == 0);

  const archetypes::owner<decltype(only_mesh(m))> a(m);
  std::size_t crossed = 0;
  const auto cross = [&](const auto&) { return ++crossed > 0; };
  CHECK(bfs(a, a.vert(vert_id{0}), {.may_cross = cross})[a.vert(vert_id{1})] == 1);
  CHECK(bfs(a, a.poly(poly_id{0}), {.may_cross = cross})[a.poly(poly_id{0})] == 0);
  CHECK(crossed > num_verts(m));
  if constexpr (dimension_v<M> == 2) {
    CHECK(boundary_loops(a).count == 1);
    CHECK_THROWS_AS(tree_cotree(a), invalid_mesh);
    CHECK_THROWS_AS(homology_generators(a), invalid_mesh);
    const archetypes::owner<decltype(only_embedded_mesh(m))> e(m);
    CHECK(cut_along(e, std::vector<edge_t<decltype(e)>>{}).verts.size() == num_verts(m));
  }
}
