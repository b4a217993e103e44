#include <concino/graph/tree_cotree.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/graph/bfs.hpp>
#include <concino/mesh/boundary.hpp>

#include <support/closed_surfaces.hpp>
#include <support/disk.hpp>
#include <support/glued_surfaces.hpp>
#include <support/kinds.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <random>
#include <set>

using namespace concino;
using namespace concino::testing;

namespace {

/// Checks that both trees are spanning forests, by naive unions, and that each edge is in exactly one of the three sets.
template<class M>
void check_decomposition(const M& m) {
  const auto t = tree_cotree(m);
  std::vector<int> met(edge_index_bound(m));
  for (const auto* part : {&t.tree, &t.cotree, &t.rest})
    for (const auto& e : *part) CHECK(++met[index_of(m, e)] == 1);
  CHECK(t.tree.size() + t.cotree.size() + t.rest.size() == num_edges(m));

  const auto components = [](std::size_t bound, const auto& elements, const auto& index, const std::vector<edge_t<M>>& joining,
                             const auto& ends, bool& forest) {
    std::vector<std::size_t> label(bound);
    for (std::size_t i = 0; i < bound; ++i) label[i] = i;
    std::size_t n = 0;
    for ([[maybe_unused]] const auto x : elements) ++n;
    for (const auto& e : joining) {
      std::vector<std::size_t> two;
      for (const auto x : ends(e)) two.push_back(label[index(x)]);
      if (two[0] == two[1]) forest = false;
      else --n;
      for (auto& l : label)
        if (l == two[1]) l = two[0];
    }
    return n;
  };
  bool forests = true;
  const auto verts_left = components(
      vert_index_bound(m), verts(m), [&](const auto& v) { return index_of(m, v); }, t.tree,
      [&](const auto& e) -> decltype(auto) { return adj_e2v(m, e); }, forests);
  const auto polys_left = components(
      poly_index_bound(m), polys(m), [&](const auto& p) { return index_of(m, p); }, t.cotree,
      [&](const auto& e) -> decltype(auto) { return adj_e2p(m, e); }, forests);
  CHECK(forests);
  const auto shape = topology_of(m);
  std::size_t lonely = 0;
  for (const auto v : verts(m)) {
    bool any = false;
    for ([[maybe_unused]] const auto p : adj_v2p(m, v)) any = true;
    lonely += !any;
  }
  CHECK(verts_left == static_cast<std::size_t>(shape.pieces) + lonely);
  CHECK(polys_left == static_cast<std::size_t>(shape.pieces));
  CHECK(static_cast<int>(t.rest.size()) == 2 * shape.pieces - shape.chi);
}

}  // namespace

TEST_CASE_TEMPLATE("tree_cotree: boards with holes have two remaining edges per hole", M, CONCINO_SURFACE_KINDS) {
  CHECK(tree_cotree(M()).tree.empty());
  for (int genus = 0; genus <= 4; ++genus) {
    const M m = from_quads<M>(holed_board(genus));
    check_decomposition(m);
    CHECK(tree_cotree(m).rest.size() == 2 * static_cast<std::size_t>(genus));
  }
}

TEST_CASE_TEMPLATE("tree_cotree: works with several components, also non-orientable ones", M, CONCINO_SURFACE_KINDS) {
  check_decomposition(from_quads<M>(rolled_grid(4, 5)));
  check_decomposition(from_quads<M>(rolled_grid(4, 5, true)));
  const M m = from_quads<M>(beside(beside(holed_board(2), rolled_grid(5, 5, true)), holed_board(0)));
  check_decomposition(m);
  CHECK(tree_cotree(m).rest.size() == 6);
}

TEST_CASE("tree_cotree: the projective plane has one remaining edge, an isolated vert none") {
  const trimesh plane(projective_plane());
  REQUIRE(topology_of(plane).chi == 1);
  check_decomposition(plane);
  CHECK(tree_cotree(plane).rest.size() == 1);
  auto with_lonely = projective_plane();
  with_lonely.points.push_back({9, 9, 9});
  check_decomposition(trimesh(with_lonely));
}

TEST_CASE_TEMPLATE("tree_cotree: the tree is breadth-first", M, CONCINO_SURFACE_KINDS) {
  const M m = from_quads<M>(holed_board(1));
  const auto t = tree_cotree(m);
  const auto hops = bfs(m, *verts(m).begin());
  for (const auto e : t.tree) {
    int sum = 0, difference = 0, sign = 1;
    for (const auto v : adj_e2v(m, e)) {
      sum += hops[v];
      difference += sign * hops[v];
      sign = -1;
    }
    CHECK(difference * difference == 1);
    CHECK(sum > 0);
  }
}

TEST_CASE_TEMPLATE("tree_cotree: runs on the archetype, with the same result on every model", M, CONCINO_SURFACE_KINDS) {
  const M m = from_quads<M>(holed_board(1));
  const auto s = only_surface_mesh(m);
  check_decomposition(s);
  const auto a = tree_cotree(m), again = tree_cotree(m);
  const auto b = tree_cotree(s);
  CHECK(a.tree == again.tree);
  CHECK(a.cotree == again.cotree);
  CHECK(a.rest == again.rest);
  REQUIRE(a.rest.size() == b.rest.size());
  for (std::size_t i = 0; i < a.rest.size(); ++i) CHECK(s.base(b.rest[i]) == a.rest[i]);
}

TEST_CASE("tree_cotree: runs on the boundary of a volume, and on a user's mesh") {
  const hexmesh block = grid<hexmesh>(2);
  check_decomposition(boundary(block));
  check_decomposition(user_mesh::surface({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
}

TEST_CASE("tree_cotree: the error names where a surface is open or non-manifold") {
  CHECK_THROWS_WITH_AS(tree_cotree(grid<quadmesh>(1)),
                       "tree_cotree: edge 0 has 1 poly; the surface must be closed, fill its borders (boundary_loops) first", invalid_mesh);
  const std::vector<vec3> points(7);
  const trimesh three(points, std::vector<std::vector<int>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}, {0, 1, 4}, {1, 3, 4}, {3, 0, 4}});
  CHECK_THROWS_WITH_AS(tree_cotree(three), doctest::Contains("has 3 polys; the surface must be manifold"), invalid_mesh);
  const trimesh touching(
      points, std::vector<std::vector<int>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}, {3, 4, 5}, {3, 5, 6}, {3, 6, 4}, {4, 6, 5}});
  CHECK_THROWS_WITH_AS(tree_cotree(touching),
                       "tree_cotree: the polys at vert 3 form several fans; the surface must be manifold, with one fan at every vert",
                       invalid_mesh);
}

TEST_CASE("tree_cotree: decomposes random voxel surfaces, or throws if they are non-manifold") {
  std::mt19937 random(5);
  int refused = 0, done = 0;
  for (int round = 0; round < 300; ++round) {
    std::set<voxel> voxels;
    const unsigned odds = 2 + static_cast<unsigned>(random() % 6);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 2; ++k)
          if (random() % 8 < odds) voxels.insert({i, j, k});
    const quadmesh m(voxel_skin(voxels));
    const auto shape = topology_of(m);
    if (shape.edges_are_manifold && shape.verts_are_manifold) {
      ++done;
      check_decomposition(m);
    } else {
      ++refused;
      CHECK_THROWS_AS(tree_cotree(m), invalid_mesh);
    }
  }
  CHECK(refused > 30);
  CHECK(done > 30);
}

TEST_CASE_TEMPLATE("tree_cotree: is right on random closed surfaces", M, CONCINO_SURFACE_KINDS) {
  std::set<std::size_t> left;
  for_random_closed_surfaces<M>(num_random_meshes(), [&](const M& m, int chi) {
    check_decomposition(m);
    left.insert(tree_cotree(m).rest.size());
    CHECK(topology_of(m).chi == chi);
  });
  for (const std::size_t n : {0u, 1u, 2u, 3u}) CHECK(left.count(n) == 1);
}
