#include <concino/fields/contour_tree.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/core/error.hpp>
#include <concino/generate/torus.hpp>
#include <concino/mesh/element_map.hpp>

#include <support/closed_surfaces.hpp>
#include <support/corpus_meshes.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <set>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M>
void check_as_reeb_graph(const M& m, std::mt19937& random) {
  auto u = make_vert_map<double>(m);
  const auto different = 1 + random() % 100;
  for (const auto v : verts(m)) u[v] = static_cast<double>(random() % different);
  const auto tree = contour_tree(m, u), graph = reeb_graph(m, u);
  CHECK(tree.nodes == graph.nodes);
  CHECK(tree.verts.size() == graph.verts.size());
  REQUIRE(tree.arcs.size() == graph.arcs.size());
  for (std::size_t k = 0; k < tree.arcs.size(); ++k) {
    CHECK(tree.arcs[k].lower == graph.arcs[k].lower);
    CHECK(tree.arcs[k].upper == graph.arcs[k].upper);
    const auto ours = tree.verts_of(tree.arcs[k]), theirs = graph.verts_of(graph.arcs[k]);
    CHECK(std::vector(ours.begin(), ours.end()) == std::vector(theirs.begin(), theirs.end()));
  }
}

}  // namespace

TEST_CASE_TEMPLATE("contour_tree: is the Reeb graph of meshes without loops", M, polygonmesh, tetmesh, hexmesh) {
  std::mt19937 random(1);
  for (unsigned round = 0; round < 12; ++round) check_as_reeb_graph(round % 2 ? grid<M>(2 + round % 3) : two_grids<M>(2), random);
}

TEST_CASE("contour_tree: of spheres, balls with a cavity, and real meshes without loops") {
  std::mt19937 random(2);
  check_as_reeb_graph(quadmesh(voxel_skin({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}})), random);
  auto hollow = hex_grid(3);
  hollow.verts.erase(hollow.verts.begin() + 8 * 13, hollow.verts.begin() + 8 * 14);  // the cell in the middle
  const hexmesh shell(hollow);
  check_as_reeb_graph(shell, random);
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  for (const auto& row : rows) {
    const auto is = [&](const char* column, const char* value) { return row.column.at(column) == value; };
    if (!is("manifold", "yes") || !is("components", "1") || is("boundary_loops", "n/a")) continue;
    if (!long_run() && std::filesystem::file_size(row.file) > 60000) continue;
    INFO(row.name);
    const auto m = load<polygonmesh>(row.file.string());
    if ((is("euler_chi", "2") && is("boundary_loops", "0")) || (is("euler_chi", "1") && is("boundary_loops", "1"))) check_as_reeb_graph(m, random);
    else CHECK_THROWS_AS(contour_tree(m, make_vert_map<double>(m)), unsupported);
  }
}

TEST_CASE("contour_tree: refuses loops and facets with three polys, saying so") {
  const auto torus = make_torus<quadmesh>({.cells = {8, 6}});
  CHECK_THROWS_WITH_AS(contour_tree(torus, make_vert_map<double>(torus)), doctest::Contains("the mesh has 2 loops that it does not fill; call reeb_graph"), unsupported);
  const auto solid = make_torus<hexmesh>({.cells = {8, 6}});
  CHECK_THROWS_WITH_AS(contour_tree(solid, make_vert_map<double>(solid)), doctest::Contains("the mesh has 1 loop that"), unsupported);
  const polygonmesh fan({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  CHECK_THROWS_WITH_AS(contour_tree(fan, make_vert_map<double>(fan)), doctest::Contains("has more than two polys"), unsupported);
  const tetmesh hinge({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}, {0, 0, -1}}, {{0, 1, 2, 3}, {0, 1, 4, 5}});
  CHECK_THROWS_WITH_AS(contour_tree(hinge, make_vert_map<double>(hinge)), doctest::Contains("has more than two boundary faces"), unsupported);
}

TEST_CASE("contour_tree: runs on archetypes and empty meshes, and rejects values that are not finite") {
  const auto m = grid<trimesh>(3);
  const auto archetype = only_surface_mesh(m);
  auto u = make_vert_map<double>(archetype);
  double next = 0;
  for (const auto v : verts(archetype)) u[v] = ++next;
  const auto tree = contour_tree(archetype, u);
  CHECK(tree.nodes.size() == 2);
  CHECK(tree.arcs.size() == 1);
  CHECK(tree.verts.size() == 14);
  const trimesh none;
  CHECK(contour_tree(none, make_vert_map<double>(none)).nodes.empty());
  auto wrong = make_vert_map<double>(m);
  wrong[vert_id{3}] = std::nan("");
  CHECK_THROWS_WITH_AS(contour_tree(m, wrong), doctest::Contains("contour_tree: the value at vert 3 is not finite"), invalid_argument);
}
