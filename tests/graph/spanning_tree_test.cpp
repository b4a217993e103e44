#include <concino/graph/spanning_tree.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/views.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("spanning_tree: has nodes minus components edges, by both methods", M, CONCINO_KINDS) {
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

TEST_CASE("spanning_tree: ties go to the first edges; infinite lengths are left out") {
  const auto m = grid<quadmesh>(1);
  const std::vector<std::pair<vert_id, vert_id>> expected = {{vert_id{0}, vert_id{1}}, {vert_id{0}, vert_id{2}}, {vert_id{1}, vert_id{3}}};
  CHECK(spanning_tree(m).arcs == expected);
  CHECK(spanning_tree(m).weight == 3);
  CHECK(spanning_tree(trimesh()).edges.empty());
  CHECK(spanning_tree(m, [](auto, auto) { return std::numeric_limits<double>::infinity(); }).arcs.empty());
  CHECK(spanning_tree(m, [](auto, auto) { return std::numeric_limits<double>::infinity(); }, {.method = tree_method::prim}).arcs.empty());
}

TEST_CASE_TEMPLATE("spanning_tree: runs on the archetype of its concept", M, CONCINO_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.05));
  const auto st = spanning_tree(m);
  const auto g = only_primal_graph(m);
  for (const auto method : {tree_method::kruskal, tree_method::prim}) {
    const auto length = [&](const auto& a, const auto& b) { return norm(to_vec3(point(m, g.base(a))) - to_vec3(point(m, g.base(b)))); };
    const auto bare = spanning_tree(g, length, {.method = method, .may_enter = [](const auto&) { return true; }});
    CHECK(bare.arcs.size() == num_verts(m) - 1);
    CHECK(bare.weight == doctest::Approx(st.weight));
    const auto d = only_dual_graph(m);
    CHECK(spanning_tree(dual(d), [](const auto&, const auto&) { return 1; }, {.method = method}).weight == double(num_polys(m) - 1));
    CHECK(spanning_tree(only_embedded_graph(m), {.method = method}).weight == doctest::Approx(st.weight));
    CHECK(spanning_tree(only_embedded_mesh(m), {.method = method}).edges.size() == st.edges.size());
  }
  static_assert(requirement::has_default_lengths<M&> && !requirement::has_default_lengths<decltype(g)> && !requirement::has_default_lengths<int>);
}

TEST_CASE("spanning_tree: throws if a length is NaN") {
  const auto m = grid<trimesh>(1);
  const auto nan = [](auto, auto) { return std::nan(""); };
  const auto endless = [](auto, auto) { return -std::numeric_limits<double>::infinity(); };
  CHECK_THROWS_WITH_AS(spanning_tree(m, nan), doctest::Contains("spanning_tree: the length from vert 0 to vert "), invalid_mesh);
  CHECK_THROWS_WITH_AS(spanning_tree(dual(m), nan, {.method = tree_method::prim}),
                       "spanning_tree: the length from poly 0 to poly 1 is not a number; lengths must be numbers, +inf for no arc", invalid_mesh);
  CHECK_THROWS_WITH_AS(spanning_tree(m, endless), doctest::Contains("is -inf"), invalid_mesh);
}
