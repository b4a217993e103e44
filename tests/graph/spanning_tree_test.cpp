#include <concino/graph/spanning_tree.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/graph/components.hpp>
#include <concino/graph/detail/disjoint_sets.hpp>

#include <support/barred_graph.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// The arcs as pairs of indices, lower first.
template<class M, class T>
std::set<std::pair<std::size_t, std::size_t>> ends(const M& m, const T& tree) {
  std::set<std::pair<std::size_t, std::size_t>> r;
  for (const auto& [a, b] : tree.arcs) r.insert(std::minmax<std::size_t>(index_of(m, a), index_of(m, b)));
  return r;
}

}  // namespace

TEST_CASE_TEMPLATE("spanning_tree: spans, is a tree, and weighs what Boost's does, on 1,000 random meshes with barriers", M, CONCINO_ALL_KINDS) {
  for_random_graphs<M>(1000, [](const auto& g) {
    using side = typename std::remove_cvref_t<decltype(g)>::side;
    const auto graph = side::view(g.m);
    const auto length = g.even_length();
    const auto boost = make_undirected(g, length);
    const auto cc = connected_components(graph, {.may_enter = g.enter(), .may_cross = g.cross()});
    std::size_t nodes = 0;
    for (const auto x : g.nodes()) nodes += cc[x] >= 0;

    const auto tree = spanning_tree(graph, length, {.may_enter = g.enter(), .may_cross = g.cross()});
    REQUIRE(tree.arcs.size() == nodes - static_cast<std::size_t>(cc.count));
    detail::disjoint_sets sets(g.bound());
    double weight = 0;
    for (const auto& [a, b] : tree.arcs) {
      REQUIRE(sets.unite(index_of(g.m, a), index_of(g.m, b)));
      REQUIRE(index_of(g.m, a) < index_of(g.m, b));
      REQUIRE((g.has_arc(a, b) && g.has_arc(b, a)));
      weight += length(a, b);
    }
    REQUIRE(tree.weight == weight);
    REQUIRE(weight == boost_tree_weight(boost));
    if constexpr (requires { tree.edges; }) {
      REQUIRE(tree.edges.size() == tree.arcs.size());
      for (std::size_t i = 0; i < tree.edges.size(); ++i) {
        auto&& at = adj_e2v(g.m, tree.edges[i]);
        const auto a = *at.begin(), b = *std::next(at.begin());
        REQUIRE(std::minmax(a, b) == std::minmax(tree.arcs[i].first, tree.arcs[i].second));
        REQUIRE(g.cross()(tree.edges[i]));
      }
    }

    const auto grown = spanning_tree(graph, length, {.method = tree_method::prim, .may_enter = g.enter(), .may_cross = g.cross()});
    REQUIRE(grown.weight == weight);
    REQUIRE(ends(g.m, grown) == ends(g.m, tree));
    std::vector<char> reached(g.bound());
    for (const auto& [a, b] : grown.arcs) {  // outward from the first node of each component
      const auto i = index_of(g.m, a), j = index_of(g.m, b);
      REQUIRE(!reached[j]);
      reached[i] = reached[j] = 1;
    }

    // The longest tree is the shortest by lengths of the other sign, and the first by the other order.
    const auto longest = spanning_tree(graph, [&](auto a, auto b) { return -length(a, b); }, {.may_enter = g.enter(), .may_cross = g.cross()});
    const auto before = [&](const auto& a, const auto& b) { return length(a.first, a.second) > length(b.first, b.second); };
    for (const auto method : {tree_method::kruskal, tree_method::prim}) {
      const auto by_order = spanning_tree(graph, length, {.method = method, .before = before, .may_enter = g.enter(), .may_cross = g.cross()});
      REQUIRE(by_order.weight == -longest.weight);
      REQUIRE(ends(g.m, by_order) == ends(g.m, longest));
    }
  });
}

TEST_CASE_TEMPLATE("spanning_tree: nodes less components, of straight lines, by both methods", M, CONCINO_ALL_KINDS) {
  const M m(jittered(two_grids_arrays<M>(3), 0.05));
  for (const auto method : {tree_method::kruskal, tree_method::prim}) {
    const auto st = spanning_tree(m, {.method = method});
    CHECK(st.edges.size() == num_verts(m) - 3);
    double weight = 0;
    for (const auto& [a, b] : st.arcs) weight += norm(to_vec3(point(m, a)) - to_vec3(point(m, b)));
    CHECK(st.weight == doctest::Approx(weight).epsilon(1e-13));
    CHECK(spanning_tree(primal(m), {.method = method}).edges == st.edges);
    const auto sd = spanning_tree(dual(m), {.method = method});
    CHECK(sd.arcs.size() == num_polys(m) - 2);
    weight = 0;
    for (const auto& [p, q] : sd.arcs) weight += norm(vert_mean(m, p) - vert_mean(m, q));
    CHECK(sd.weight == doctest::Approx(weight).epsilon(1e-13));
  }
}

TEST_CASE("spanning_tree: of a grid whose edges are equally long, the first edges; none of what is empty or infinitely long") {
  const auto m = grid<quadmesh>(1);
  const std::vector<std::pair<vert_id, vert_id>> expected = {{vert_id{0}, vert_id{1}}, {vert_id{0}, vert_id{2}}, {vert_id{1}, vert_id{3}}};
  CHECK(spanning_tree(m).arcs == expected);
  CHECK(spanning_tree(m).weight == 3);
  CHECK(spanning_tree(trimesh()).edges.empty());
  CHECK(spanning_tree(m, [](auto, auto) { return std::numeric_limits<double>::infinity(); }).arcs.empty());
  CHECK(spanning_tree(m, [](auto, auto) { return std::numeric_limits<double>::infinity(); }, {.method = tree_method::prim}).arcs.empty());
}

TEST_CASE_TEMPLATE("spanning_tree: uses nothing but its concept", M, CONCINO_ALL_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.05));
  const auto st = spanning_tree(m);
  const auto g = only_primal_graph(m);
  for (const auto method : {tree_method::kruskal, tree_method::prim}) {
    const auto length = [&](const auto& a, const auto& b) { return norm(to_vec3(point(m, g.base(a))) - to_vec3(point(m, g.base(b)))); };
    const auto bare = spanning_tree(g, length, {.method = method, .may_enter = [](const auto&) { return true; }});
    CHECK(bare.arcs.size() == num_verts(m) - 1);
    CHECK(bare.weight == doctest::Approx(st.weight));
    const auto d = only_dual_graph(m);
    CHECK(spanning_tree(d, [](const auto&, const auto&) { return 1; }, {.method = method}).weight == double(num_polys(m) - 1));
    CHECK(spanning_tree(only_embedded_graph(m), {.method = method}).weight == doctest::Approx(st.weight));
    CHECK(spanning_tree(only_embedded_mesh(m), {.method = method}).edges.size() == st.edges.size());
  }
  static_assert(requirement::has_default_lengths<M&> && !requirement::has_default_lengths<decltype(g)> && !requirement::has_default_lengths<int>);
}

TEST_CASE("spanning_tree: lengths that are no numbers are refused") {
  const auto m = grid<trimesh>(1);
  const auto nan = [](auto, auto) { return std::nan(""); };
  const auto endless = [](auto, auto) { return -std::numeric_limits<double>::infinity(); };
  CHECK_THROWS_WITH_AS(spanning_tree(m, nan), doctest::Contains("spanning_tree: the length from vert 0 to vert "), invalid_mesh);
  CHECK_THROWS_WITH_AS(spanning_tree(dual(m), nan, {.method = tree_method::prim}),
                       "spanning_tree: the length from poly 0 to poly 1 is not a number; lengths must be numbers, +inf for no arc", invalid_mesh);
  CHECK_THROWS_WITH_AS(spanning_tree(m, endless), doctest::Contains("is -inf"), invalid_mesh);
}
