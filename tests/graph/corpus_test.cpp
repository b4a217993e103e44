// Searches and shortest paths on real meshes agree with Boost.Graph and with known results.
#include <concino/graph.hpp>

#include <support/boost_graph.hpp>
#include <support/corpus_meshes.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <utility>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M, class All, class Mine, class Hops>
void compare(const M& m, const All& all, const boost_graph& g, const Mine& mine, const Hops& hops) {
  std::size_t n = 0, wrong = 0;
  for ([[maybe_unused]] const auto x : all) ++n;
  std::size_t i = 0;
  for (const auto s : all) {
    if (i++ % (n / 2 + 1) != 0) continue;  // only the first node and one in the middle
    const auto d = mine(s);
    const auto h = hops(s);
    const auto expected = boost_distances(g, index_of(m, s));
    const auto expected_hops = boost_hops(g, index_of(m, s));
    for (const auto x : all) {
      const double e = expected[index_of(m, x)];
      wrong += !(d[x] == e || std::abs(d[x] - e) <= 1e-12 * e) || h[x] != expected_hops[index_of(m, x)];
    }
  }
  CHECK(wrong == 0);
}

}  // namespace

TEST_CASE("corpus: bfs and dijkstra agree with Boost.Graph on verts and polys of every mesh") {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  for (const auto& row : rows) {
    INFO(row.name);
    std::visit(
        [](const auto& m) {
          using M = std::remove_cvref_t<decltype(m)>;
          const auto length = [&](auto v, auto w) { return norm(to_vec3(point(m, v)) - to_vec3(point(m, w))); };
          compare(m, verts(m), make_boost_graph(vert_index_bound(m), primal_arcs(m, length)), [&](vert_t<M> v) { return dijkstra(m, v); },
                  [&](vert_t<M> v) { return bfs(m, v); });
          const auto centres = [&](auto p, auto q) { return norm(vert_mean(m, p) - vert_mean(m, q)); };
          compare(m, polys(m), make_boost_graph(poly_index_bound(m), dual_arcs(m, centres)), [&](poly_t<M> p) { return dijkstra(m, p); },
                  [&](poly_t<M> p) { return bfs(m, p); });
        },
        load_any(row.file.string()));
  }
}

TEST_CASE("corpus: shortest edge paths on the sphere have the known lengths") {
  CONCINO_CORPUS_OR_SKIP(path, "tri/sphere.obj");
  const auto m = load<trimesh>(path.string());
  const auto d = dijkstra(m, vert_id{0});
  const std::pair<unsigned, double> known[] = {
      {1, 0.117679207958},    {100, 0.361457679988},  {500, 1.2237054537},    {1000, 0.81338924806},  {2000, 0.380579798955},
      {3000, 0.652902252888}, {4223, 0.744730608297}, {5000, 0.576758719321}, {6000, 0.478578920533}, {7000, 0.569661811951},
      {8000, 0.951433913875}, {8446, 1.01887612291},  {6461, 1.60882348522}};
  for (const auto& [v, expected] : known) CHECK(d[vert_id{v}] == doctest::Approx(expected).epsilon(1e-11));

  const double radius = 0.5;
  const vec3 source = to_vec3(point(m, vert_id{0}));
  double worst = 0, farthest = 0;
  vert_id where;
  for (const auto v : verts(m)) {
    const vec3 x = to_vec3(point(m, v));
    const double circle = radius * std::atan2(norm(cross(source, x)), dot(source, x));
    if (circle > 0.05) worst = std::max(worst, d[v] / circle);
    if (circle > farthest) {
      farthest = circle;
      where = v;
    }
  }
  CHECK(worst == doctest::Approx(1.15298952009).epsilon(1e-10));
  CHECK(where == vert_id{6461});  // the farthest vert by great circles
}
