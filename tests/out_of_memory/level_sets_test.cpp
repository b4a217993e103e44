// Finding a level set, or clipping, that runs out of memory throws std::bad_alloc and leaks nothing, with helper threads too.
#include <concino/level_sets.hpp>

#include <concino/generate/grid.hpp>
#include <concino/mesh.hpp>

#include <support/failing_allocations.hpp>
#include <support/threads.hpp>

#include <doctest/doctest.h>

#include <cstddef>

namespace cn = concino;

namespace {

template<class M>
auto distances(const M& m, const cn::vec3& centre) {
  auto u = cn::make_vert_map<double>(m);
  for (const auto v : cn::verts(m)) u[v] = cn::norm(cn::point(m, v) - centre);
  return u;
}

/// Runs find() with failing allocations, and checks that it has the same result as before whenever none fails.
template<class F>
void check_failures(const F& find, std::size_t expected, std::size_t sparsity) {
  std::size_t wrong = 0;
  const auto result = cn::testing::for_each_failing_allocation(
      [&](const auto& attempt) {
        std::size_t found = 0;
        if (!attempt([&] { found = find(); })) wrong += found != expected;
      },
      sparsity);
  CHECK(result.failed > 8);
  CHECK(result.leaks == 0);
  CHECK(wrong == 0);
}
template<class F>
void check_failures(const F& find, std::size_t sparsity = 0) {
  const std::size_t expected = find();
  CHECK(expected > 0);
  check_failures(find, expected, sparsity);
}

}  // namespace

TEST_CASE_TEMPLATE("lines and clips that run out of memory", M, cn::trimesh, cn::quadmesh, cn::polygonmesh) {
  const M m = cn::make_grid<M>({.cells = {4, 4, 1}});
  const auto u = distances(m, {0.45, 0.55, 0});
  for (const double level : {0.3, u[*cn::verts(m).begin()]}) {  // the fast way of isolines, and a vert on the level set
    check_failures([&] {
      std::size_t n = 0;
      for (const auto& line : cn::isolines(m, u, level)) n += line.points.size();
      return n;
    });
    check_failures([&] { return cn::num_polys(cn::clip(m, u, level).mesh); });
  }
}

TEST_CASE_TEMPLATE("iso-surfaces and clips that run out of memory", M, cn::tetmesh, cn::hexmesh, cn::polyhedralmesh) {
  const M m = cn::make_grid<M>({.cells = {3, 3, 3}});
  const auto u = distances(m, {0.45, 0.55, 0.4});
  for (const double level : {0.3, u[*cn::verts(m).begin()]}) {
    check_failures([&] { return cn::num_polys(cn::isosurface(m, u, level).mesh); }, 20);
    check_failures([&] { return cn::num_polys(cn::clip(m, u, level).mesh); }, 20);
  }
}

TEST_CASE("level sets that run out of memory in two threads") {
  const cn::testing::with_num_threads two(2);
  const auto triangles = cn::make_grid<cn::trimesh>({.cells = {230, 230, 1}});
  const auto on_triangles = distances(triangles, {0.45, 0.55, 0});
  check_failures([&] { return cn::isolines(triangles, on_triangles, 0.3).size(); }, 2);
  const auto cells = cn::make_grid<cn::polyhedralmesh>({.cells = {47, 47, 47}});
  const auto in_cells = distances(cells, {0.45, 0.55, 0.4});
  check_failures([&] { return cn::num_polys(cn::isosurface(cells, in_cells, 0.1).mesh); }, 2);
  check_failures([&] { return cn::num_polys(cn::clip(cells, in_cells, 0.1).mesh); }, 1);
}
