// Spanning trees of real meshes, with and without random barriers, agree with Boost.Graph.
#include <concino/graph/components.hpp>
#include <concino/graph/spanning_tree.hpp>

#include <support/corpus_graphs.hpp>

#include <doctest/doctest.h>

#include <vector>

using namespace concino;
using namespace concino::testing;

TEST_CASE("corpus: spanning trees agree with Boost.Graph on verts and polys of every mesh") {
  for_corpus_graphs([]<class Side>(barred_graph<Side>& g) {
    const auto graph = Side::view(g.m);
    const auto length = g.even_length();
    const auto cc = connected_components(graph, {.may_enter = g.enter(), .may_cross = g.cross()});
    std::size_t open = 0;
    for (const auto x : g.nodes()) open += cc[x] >= 0;
    const auto behind_walls = spanning_tree(graph, length, {.may_enter = g.enter(), .may_cross = g.cross()});
    CHECK(behind_walls.arcs.size() == open - static_cast<std::size_t>(cc.count));
    CHECK(behind_walls.weight == boost_tree_weight(make_undirected(g, length)));

    if (g.bound() > 15000) return;  // larger meshes take too long
    tear_down_walls(g);
    std::vector<vec3> place(g.bound());
    for (const auto x : g.nodes()) {
      if constexpr (std::same_as<Side, primal_side<typename Side::M>>) place[index_of(g.m, x)] = to_vec3(point(g.m, x));
      else place[index_of(g.m, x)] = vert_mean(g.m, x);
    }
    const auto straight = [&](auto a, auto b) { return norm(place[index_of(g.m, a)] - place[index_of(g.m, b)]); };
    const auto tree = spanning_tree(graph);
    CHECK(tree.arcs.size() == g.nodes().size() - static_cast<std::size_t>(connected_components(graph).count));
    CHECK(tree.weight == doctest::Approx(boost_tree_weight(make_undirected(g, straight))).epsilon(1e-9));
    if (g.bound() < 2000)
      CHECK(spanning_tree(graph, {.method = tree_method::prim}).weight == doctest::Approx(tree.weight).epsilon(1e-9));
  });
}
