#include <concino/fields/reeb_graph.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/core/error.hpp>
#include <concino/fields/critical_points.hpp>
#include <concino/generate/torus.hpp>
#include <concino/mesh/element_map.hpp>

#include <support/closed_surfaces.hpp>
#include <support/corpus_meshes.hpp>
#include <support/kinds.hpp>
#include <support/random_meshes.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// The links by the components of the level set between each pair of successive verts, each found anew.
std::vector<concino::detail::level_link> links_by_search(const concino::detail::level_complex& c, std::uint32_t n) {
  std::vector<concino::detail::level_link> links;
  std::vector<std::uint32_t> last(c.edges.size(), concino::detail::no_rank), label(c.edges.size());
  for (std::uint32_t v = 0; v < n; ++v) {
    std::iota(label.begin(), label.end(), 0u);  // of edges by their component just below v
    const auto find = [&](std::uint32_t e) {
      while (label[e] != e) e = label[e];
      return e;
    };
    const auto unite = [&](std::uint32_t a, std::uint32_t b) { label[std::max(find(a), find(b))] = std::min(find(a), find(b)); };
    const auto crosses = [&](std::uint32_t e) { return c.edges[e][0] < v && c.edges[e][1] >= v; };
    for (const auto& [ac, ab, bc] : c.triangles) {
      if (crosses(ac) && crosses(ab)) unite(ac, ab);
      if (crosses(ac) && crosses(bc)) unite(ac, bc);
    }
    std::vector<std::uint32_t> last_of(c.edges.size(), concino::detail::no_rank);  // the highest vert below that a component met
    for (std::uint32_t e = 0; e < c.edges.size(); ++e)
      if (crosses(e) && (last_of[find(e)] == concino::detail::no_rank || last_of[find(e)] < last[e])) last_of[find(e)] = last[e];
    std::vector<std::uint32_t> below;
    for (std::uint32_t e = 0; e < c.edges.size(); ++e)
      if (c.edges[e][1] == v) below.push_back(find(e));
    std::sort(below.begin(), below.end());
    below.erase(std::unique(below.begin(), below.end()), below.end());
    for (const auto component : below) links.push_back({last_of[component], v});
    for (std::uint32_t e = 0; e < c.edges.size(); ++e)
      if (c.edges[e][0] == v) last[e] = v;
  }
  return links;
}

template<class M>
void check_links(const M& m, std::mt19937& random, unsigned different) {
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = static_cast<double>(random() % different);
  const concino::detail::sorted_verts<M> sorted(m, u, "test");
  const auto complex = concino::detail::make_level_complex(m, sorted);
  auto ours = concino::detail::find_level_links(complex, sorted.size()), expected = links_by_search(complex, sorted.size());
  std::sort(ours.begin(), ours.end());
  std::sort(expected.begin(), expected.end());
  CHECK(ours == expected);
  const auto graph = reeb_graph(m, u);
  CHECK(graph.nodes.size() + graph.verts.size() == num_verts(m));
  const auto rank = [&](const vert_t<M>& v) { return sorted.rank[index_of(m, v)]; };
  for (const auto& a : graph.arcs) {
    auto last = rank(graph.nodes[a.lower]);
    for (const auto& v : graph.verts_of(a)) {
      CHECK(rank(v) > last);
      last = rank(v);
    }
    CHECK(rank(graph.nodes[a.upper]) > last);
  }
}

/// Checks that arcs - nodes + 1 is the genus, for random values and for heights, where no saddle has three valleys; with such saddles it can be less.
/// Returns how often there was none.
template<class M>
unsigned check_loops(const M& m, std::mt19937& random, std::ptrdiff_t genus) {
  unsigned simple = 0;
  for (const bool by_height : {false, true}) {
    auto u = make_vert_map<double>(m);
    const vec3 up{random() % 100, random() % 100, random() % 100};
    for (const auto v : verts(m)) u[v] = by_height ? dot(to_vec3(point(m, v)), up) : static_cast<double>(random());
    const auto graph = reeb_graph(m, u);
    const auto c = critical_points(m, u);
    const auto loops = static_cast<std::ptrdiff_t>(graph.arcs.size()) - static_cast<std::ptrdiff_t>(graph.nodes.size()) + 1;
    CHECK(loops <= genus);
    if (!std::all_of(c.verts.begin(), c.verts.end(), [&](const auto& v) { return c[v][1] < 2; })) continue;
    CHECK(loops == genus);
    ++simple;
  }
  return simple;
}

}  // namespace

TEST_CASE_TEMPLATE("reeb_graph: its links are those of the components between successive verts, on random meshes", M, polygonmesh, tetmesh, hexmesh) {
  std::mt19937 random(1);
  for (unsigned round = 0; round < num_random_meshes() / 4; ++round) {
    CAPTURE(round);
    check_links(round % 4 == 0 ? grid<M>(2) : random_mesh<M>(random), random, 1 + static_cast<unsigned>(random() % 40));
  }
}

TEST_CASE("reeb_graph: of a torus on its side: a leaf, a loop of two arcs, and a leaf") {
  const auto m = make_torus<quadmesh>({.cells = {24, 12}});
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = point(m, v)[0] + 1e-3 * point(m, v)[1] + 1e-4 * point(m, v)[2];
  const auto g = reeb_graph(m, u);
  REQUIRE(g.nodes.size() == 4);
  REQUIRE(g.arcs.size() == 4);
  const std::size_t ends[4][2] = {{0, 1}, {1, 2}, {1, 2}, {2, 3}};
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(g.arcs[k].lower == ends[k][0]);
    CHECK(g.arcs[k].upper == ends[k][1]);
  }
  CHECK(g.verts.size() == num_verts(m) - 4);
  for (const auto v : g.verts_of(g.arcs[1])) CHECK(point(m, v)[1] * point(m, g.verts_of(g.arcs[2])[0])[1] <= 0.05);  // two sides
}

TEST_CASE("reeb_graph: has as many loops as a closed orientable surface has handles, if saddles are simple") {
  std::mt19937 random(2);
  for (unsigned genus = 0; genus < 4; ++genus) {
    std::set<voxel> voxels;  // a plate with holes
    for (int i = 0; i < static_cast<int>(2 * genus + 1); ++i)
      for (int j = 0; j < 3; ++j)
        if (!(i % 2 == 1 && j == 1)) voxels.insert({i, j, 0});
    const quadmesh m(voxel_skin(voxels));
    unsigned simple = 0;
    for (unsigned round = 0; round < 5; ++round) simple += check_loops(m, random, genus);
    CHECK(simple > 0);
  }
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  unsigned simple = 0;
  for (const auto& row : rows) {
    const auto is = [&](const char* column, const char* value) { return row.column.at(column) == value; };
    if (!is("manifold", "yes") || !is("boundary_loops", "0") || !is("components", "1")) continue;
    if (!long_run() && std::filesystem::file_size(row.file) > 60000) continue;
    INFO(row.name);
    const auto m = load<polygonmesh>(row.file.string());
    simple += check_loops(m, random, std::stoi(row.column.at("genus")));
  }
  CHECK(simple > 3);
}

TEST_CASE("reeb_graph: runs on archetypes and empty meshes, and rejects values that are not finite") {
  const auto m = two_grids<trimesh>(2);
  const auto archetype = only_surface_mesh(m);
  auto u = make_vert_map<double>(archetype);
  double next = 0;
  for (const auto v : verts(archetype)) u[v] = ++next;
  const auto g = reeb_graph(archetype, u);
  CHECK(g.nodes.size() == 5);  // a line each, and a vert alone
  CHECK(g.arcs.size() == 2);
  const trimesh none;
  CHECK(reeb_graph(none, make_vert_map<double>(none)).nodes.empty());
  auto wrong = make_vert_map<double>(m);
  wrong[vert_id{3}] = std::nan("");
  CHECK_THROWS_WITH_AS(reeb_graph(m, wrong), doctest::Contains("reeb_graph: the value at vert 3 is not finite"), invalid_argument);
}
