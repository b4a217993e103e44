#include <concino/graph/components.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/graph/bfs.hpp>

#include <support/barred_graph.hpp>

#include <doctest/doctest.h>

#include <map>

using namespace concino;
using namespace concino::testing;

namespace {

template<class G> concept has_components = requires { connected_components(std::declval<G>()); };

}  // namespace

TEST_CASE_TEMPLATE("connected_components: equal Boost's on random meshes with barriers", M, CONCINO_KINDS) {
  for_random_graphs<M>(num_random_meshes(), [](const auto& g) {
    using side = typename std::remove_cvref_t<decltype(g)>::side;
    const auto graph = side::view(g.m);
    const auto cc = connected_components(graph, {.may_enter = g.enter(), .may_cross = g.cross()});
    const auto expected = boost_components(make_undirected(g, g.even_length()));
    std::map<int, int> number;  // by Boost's labels
    for (const auto x : g.nodes()) {
      const auto i = index_of(g.m, x);
      if (!g.free_node[i]) {
        REQUIRE(cc[x] == -1);
        continue;
      }
      const auto found = number.emplace(expected[i], static_cast<int>(number.size())).first;
      REQUIRE(cc[x] == found->second);
    }
    REQUIRE(cc.count == static_cast<int>(number.size()));

    const auto all = connected_components(graph);
    int pieces = 0;
    for (const auto x : g.nodes()) {
      if (all[x] < pieces) continue;
      REQUIRE(all[x] == pieces++);
      const auto hops = bfs(graph, x);
      for (const auto y : g.nodes()) REQUIRE((hops[y] >= 0) == (all[y] == all[x]));
    }
    REQUIRE(all.count == pieces);
  });
}

TEST_CASE_TEMPLATE("connected_components: are right for two grids, an isolated vert and the empty mesh", M, CONCINO_KINDS) {
  const M m = two_grids<M>(2);
  const auto cc = connected_components(m);
  CHECK(cc.count == 3);
  CHECK(cc[vert_id{0}] == 0);
  CHECK(cc[vert_id{static_cast<unsigned>(num_verts(m) - 2)}] == 1);
  CHECK(cc[vert_id{static_cast<unsigned>(num_verts(m) - 1)}] == 2);
  const auto cd = connected_components(dual(m));
  CHECK(cd.count == 2);
  CHECK(cd[poly_id{static_cast<unsigned>(num_polys(m) - 1)}] == 1);
  CHECK(connected_components(dual(m), {.may_cross = [](auto) { return false; }}).count == static_cast<int>(num_polys(m)));
  CHECK(connected_components(m, {.may_enter = [](auto) { return false; }}).count == 0);
  const M none;
  CHECK(connected_components(none).count == 0);
  CHECK(connected_components(dual(none)).count == 0);
}

TEST_CASE_TEMPLATE("connected_components: run on the archetypes of primal and dual graphs", M, CONCINO_KINDS) {
  const M m = two_grids<M>(1);
  const auto g = only_primal_graph(m);
  const auto d = only_dual_graph(m);
  const auto cc = connected_components(g, {.may_enter = [](const auto&) { return true; }});
  const auto cd = connected_components(dual(d));
  CHECK(cc.count == 3);
  CHECK(cd.count == 2);
  for (const auto v : verts(g)) CHECK(cc[v] == connected_components(m)[g.base(v)]);
  for (const auto p : polys(d)) CHECK(cd[p] == connected_components(dual(m))[d.base(p)]);
  static_assert(has_components<views::dual_view<M>&> && !has_components<decltype(d)&>);  // dual(m) says that polys are meant, a dual graph itself does not
  static_assert(has_components<trimesh&> && !has_components<trimesh> && !has_components<int&>);
}
