#include <concino/generate/random_labels.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/generate/agglomerate.hpp>
#include <concino/generate/grid.hpp>

#include <support/closed_surfaces.hpp>
#include <support/generated.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <set>
#include <vector>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("random_labels: pieces can be merged and have about the requested size", M, CONCINO_KINDS) {
  const M m = make_grid<M>({.cells = {SurfaceMesh<M> ? 12u : 6u, SurfaceMesh<M> ? 12u : 6u, 6}});
  for (const std::size_t size : {2u, 5u, 20u}) {
    const auto labels = random_labels(m, size, size);
    std::set<int> met;
    for (const poly_t<M> p : polys(m)) met.insert(labels[p]);
    CHECK(*met.begin() == 0);
    CHECK(*met.rbegin() == static_cast<int>(met.size()) - 1);
    CHECK(met.size() >= num_polys(m) / size);
    CHECK(met.size() < 1.8 * static_cast<double>(num_polys(m)) / static_cast<double>(size));
    const auto a = agglomerate(m, labels);
    check_sound(a, 1);
    CHECK(num_polys(a) == met.size());
    CHECK(total_measure(a) == doctest::Approx(1).epsilon(1e-12));
  }
}

TEST_CASE_TEMPLATE("random_labels: depends only on the seed, also on archetypes", M, CONCINO_KINDS) {
  const M m = make_grid<M>({.cells = {4, 4, 3}});
  const auto a = random_labels(m, 4), b = random_labels(m, 4), c = random_labels(m, 4, 2);
  const auto bare = only_mesh(m);
  const auto d = random_labels(bare, 4);
  bool differs = false;
  for (const poly_t<M> p : polys(m)) {
    CHECK(a[p] == b[p]);
    differs = differs || a[p] != c[p];
  }
  CHECK(differs);
  int count = 0;
  for (const auto p : polys(bare)) count = std::max(count, d[p]);
  CHECK(count > 0);
  const auto single = random_labels(m, 1);
  std::set<int> met;
  for (const poly_t<M> p : polys(m)) met.insert(single[p]);
  CHECK(met.size() == num_polys(m));
  CHECK_THROWS_WITH_AS(random_labels(m, 0), "random_labels: size is 0; it must be at least 1", invalid_argument);
  const M none;
  CHECK(random_labels(none, 3).values().empty());
}

TEST_CASE("random_labels: works on closed, disconnected and non-manifold meshes") {
  const quadmesh board(holed_board(2));
  const auto labels = random_labels(board, 1000000);
  const auto a = agglomerate(board, labels);
  CHECK(num_polys(a) > 1);
  CHECK(check_laws(a).empty());
  const auto two = two_grids<polyhedralmesh>(2);
  CHECK(total_measure(agglomerate(two, random_labels(two, 100))) == doctest::Approx(2));
  const trimesh book({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  CHECK(num_polys(agglomerate(book, random_labels(book, 3))) >= 2);
  const trimesh turned({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 3, 2}});
  CHECK(num_polys(agglomerate(turned, random_labels(turned, 2))) == 2);
}
