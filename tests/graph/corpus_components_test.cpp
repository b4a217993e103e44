// Components, regions, spanning trees and shortest paths on real meshes, against Boost.Graph.
#include <concino/graph/components.hpp>
#include <concino/graph/grow_regions.hpp>
#include <concino/graph/shortest_path.hpp>
#include <concino/graph/spanning_tree.hpp>

#include <support/barred_graph.hpp>
#include <support/corpus_meshes.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <map>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// graph: primal(m) or dual(m); all: its nodes; length: from node to node.
template<class M, class G, class All, class L>
void compare(const M& m, const G& graph, const All& all, const std::vector<arc>& arcs, std::size_t bound, const L& length) {
  boost_undirected undirected(bound);
  for (const arc& a : arcs)
    if (a.from < a.to) add_edge(a.from, a.to, a.length, undirected);
  const auto component = boost_components(undirected);

  using node = std::remove_cvref_t<decltype(*all.begin())>;
  std::vector<node> nodes, seeds;
  const auto cc = connected_components(graph);
  std::map<int, int> number;
  std::size_t wrong = 0;
  for (const node x : all) {
    nodes.push_back(x);
    const auto known = number.emplace(component[index_of(m, x)], static_cast<int>(number.size()));
    wrong += cc[x] != known.first->second;
    if (known.second) seeds.push_back(x);
  }
  CHECK(wrong == 0);
  CHECK(cc.count == static_cast<int>(number.size()));

  const auto rg = grow_regions(graph, seeds, [](auto, auto) { return true; });
  for (const node x : nodes) wrong += rg[x] != cc[x];
  CHECK(wrong == 0);

  const auto tree = spanning_tree(graph, length);
  CHECK(tree.arcs.size() == nodes.size() - seeds.size());
  CHECK(tree.weight == doctest::Approx(boost_tree_weight(undirected)).epsilon(1e-9));
  if (nodes.size() < 3000)  // else it takes long
    CHECK(spanning_tree(graph, length, {.method = tree_method::prim}).weight == doctest::Approx(tree.weight).epsilon(1e-9));

  if (nodes.empty()) return;
  const node end = nodes[nodes.size() / 2];
  const auto path = shortest_path(graph, nodes.front(), end, length);
  double sum = path.empty() ? std::numeric_limits<double>::infinity() : 0;
  for (std::size_t i = 1; i < path.size(); ++i) sum += length(path[i - 1], path[i]);
  const double expected = boost_distances(make_boost_graph(bound, arcs), index_of(m, nodes.front()))[index_of(m, end)];
  CHECK((sum == expected || std::abs(sum - expected) <= 1e-12 * expected));
}

}  // namespace

TEST_CASE("corpus: components, regions, trees and paths agree with Boost.Graph on verts and polys of every mesh") {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  for (const auto& row : rows) {
    INFO(row.name);
    std::visit(
        [](const auto& m) {
          const auto straight = [&](auto v, auto w) { return norm(to_vec3(point(m, v)) - to_vec3(point(m, w))); };
          compare(m, primal(m), verts(m), primal_arcs(m, straight), vert_index_bound(m), straight);
          const auto centres = [&](auto p, auto q) { return norm(vert_mean(m, p) - vert_mean(m, q)); };
          compare(m, dual(m), polys(m), dual_arcs(m, centres), poly_index_bound(m), centres);
        },
        load_any(row.file.string()));
  }
}
