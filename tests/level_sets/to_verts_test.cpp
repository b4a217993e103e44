#include <concino/level_sets/to_verts.hpp>

#include <concino/level_sets/isolines.hpp>

#include <support/kinds.hpp>
#include <support/level_sets.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("to_verts: constants stay, and means lie between the values around", M, CONCINO_KINDS) {
  std::mt19937 random(1);
  for (int i = 0; i < 10; ++i) {
    const M m = mesh_to_cut<M>(random);
    auto q = make_poly_map<int>(m, 3);
    for (const auto v : verts(m)) CHECK(to_verts(m, q)[v] == doctest::Approx(3).epsilon(1e-15));
    for (const auto p : polys(m)) q[p] = static_cast<int>(random() % 10);
    const auto u = to_verts(m, q);
    for (const auto v : verts(m)) {
      int least = 10, most = -1;
      for (const auto p : adj_v2p(m, v)) least = std::min(least, q[p]), most = std::max(most, q[p]);
      CHECK(u[v] >= least - 1e-12);
      CHECK(u[v] <= most + 1e-12);
    }
  }
}

TEST_CASE("to_verts: weights are the measures of polys") {
  // Squares of sides 1 and 2 beside each other.
  const polygonmesh m({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {3, 0, 0}, {3, 2, 0}, {1, 2, 0}, {9, 9, 9}}, {{0, 1, 2, 3}, {1, 4, 5, 6, 2}});
  auto q = make_poly_map<double>(m);
  q[poly_id(0)] = 10;
  const auto u = to_verts(m, q);
  CHECK(u[vert_id(0)] == 10);
  CHECK(u[vert_id(1)] == doctest::Approx(2));  // 10 * 1 / (1 + 4)
  CHECK(u[vert_id(4)] == 0);
  CHECK(u[vert_id(7)] == 0);  // no polys
  CHECK(isolines(m, u, 1.0).size() == 1);
}

TEST_CASE("to_verts: polys of no size count equally, and NaN stays NaN") {
  const trimesh m({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 1, 2}, {1, 3, 2}});
  auto q = make_poly_map<double>(m);
  q[poly_id(1)] = 4;
  CHECK(to_verts(m, q)[vert_id(1)] == 2);
  q[poly_id(0)] = std::nan("");
  CHECK(std::isnan(to_verts(m, q)[vert_id(0)]));
  CHECK(!std::isnan(to_verts(m, q)[vert_id(3)]));
}
