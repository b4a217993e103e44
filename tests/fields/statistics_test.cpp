#include <concino/fields/statistics.hpp>

#include <concino/concepts/archetypes.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("statistics: of a linear function on the unit square or cube, at verts and at polys", M, CONCINO_KINDS) {
  const M m = grid<M>(4);
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = 3 * point(m, v)[0] + 1;
  const auto s = statistics(m, u);
  CHECK(s.min == 1);
  CHECK(s.max == 4);
  CHECK(point(m, *s.min_at)[0] == 0);
  CHECK(point(m, *s.max_at)[0] == 1);
  CHECK(s.mean > 2.2);
  CHECK(s.mean < 2.8);
  CHECK(s.integral == doctest::Approx(s.mean));
  CHECK(s.count == num_verts(m));
  auto q = make_poly_map<double>(m);
  double sum = 0;
  for (const auto p : polys(m)) {
    q[p] = static_cast<double>(index_of(m, p));
    sum += q[p] * measure(m, p);
  }
  const auto of_polys = statistics(m, q);
  CHECK(of_polys.integral == doctest::Approx(sum));
  CHECK(*of_polys.min_at == poly_id{0});
  CHECK(of_polys.max == static_cast<double>(num_polys(m) - 1));
}

TEST_CASE("statistics: weights are areas, the deviation is the root of the mean square, and scales and constants lose no digits") {
  const polygonmesh m({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {4, 0, 0}, {4, 1, 0}}, {{0, 1, 2, 3}, {1, 4, 5, 2}});  // areas 1 and 3
  auto q = make_poly_map<double>(m);
  for (const double scale : {1.0, 1e-300, 1e300}) {
    q[poly_id{0}] = 2 * scale, q[poly_id{1}] = 6 * scale;
    const auto s = statistics(m, q);
    CHECK(s.mean / scale == doctest::Approx(5));
    CHECK(s.deviation / scale == doctest::Approx(std::sqrt(3.0)));
  }
  q[poly_id{0}] = 1e15 + 1, q[poly_id{1}] = 1e15 + 2;
  CHECK(statistics(m, q).deviation == doctest::Approx(std::sqrt(0.1875)));
  q[poly_id{0}] = -1e308, q[poly_id{1}] = 1e308;
  CHECK(statistics(m, q).mean == doctest::Approx(0.5e308));
  CHECK(statistics(m, make_poly_map<double>(m, 0.1)).mean == 0.1);
}

TEST_CASE("statistics: values that are not finite are counted and left out; meshes without measure or elements; archetypes") {
  const auto m = grid<trimesh>(2);
  const auto archetype = only_embedded_mesh(m);
  auto u = make_vert_map<double>(archetype, 2.0);
  double next = 0;
  for (const auto v : verts(archetype))
    if (++next > 7) u[v] = next > 8 ? std::nan("") : std::numeric_limits<double>::infinity();
  const auto s = statistics(archetype, u);
  CHECK(s.not_finite == 2);
  CHECK(s.count == 7);
  CHECK(s.mean == 2);
  CHECK(s.deviation == 0);
  const trimesh none;
  CHECK(!statistics(none, make_vert_map<double>(none)).min_at);
  const trimesh flat({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
  auto w = make_vert_map<double>(flat);
  w[vert_id{1}] = 3;
  CHECK(statistics(flat, w).mean == 1);
  CHECK(statistics(flat, w).integral == 0);
  const trimesh broken({{0, 0, 0}, {1, 0, 0}, {0, std::nan(""), 0}}, {{0, 1, 2}});
  CHECK_THROWS_AS(statistics(broken, make_vert_map<double>(broken)), invalid_mesh);
}
