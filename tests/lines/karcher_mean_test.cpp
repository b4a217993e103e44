#include <concino/lines/karcher_mean.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/generate/icosphere.hpp>

#include <support/geodesic_errors.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("karcher_mean: is the mean of points on the plane", M, trimesh, polygonmesh) {
  const M m = square_or_cube<M>(8);
  const vert_id a = nearest(m, {0, 0, 0}), b = nearest(m, {1, 0.2, 0}), c = nearest(m, {0.4, 1, 0});
  CHECK(distance(karcher_mean(m, {a, b, c}).position, (point(m, a) + point(m, b) + point(m, c)) / 3) < 1e-9);
  const vec3 weighted = (0.5 * point(m, a) + 3 * point(m, b)) / 3.5;
  CHECK(distance(karcher_mean(m, {{a, 0.5}, {b, 3.0}}).position, weighted) < 1e-9);
  const auto log = prepare_log_map(m);
  CHECK(distance(karcher_mean(log, std::vector<std::pair<vert_id, double>>{{a, 0.5}, {b, 3.0}, {c, 0.0}}).position, weighted) < 1e-9);
  CHECK(karcher_mean(log, std::vector<vert_id>{c}).position == point(m, c));
}

TEST_CASE("karcher_mean: converges on the sphere") {
  double before = 1;
  for (const unsigned k : {2u, 4u}) {
    const trimesh m = icosphere(k);
    const vert_id a = nearest(m, {1, 0, 0}), b = nearest(m, {0, 1, 0});
    const vec3 x = karcher_mean(m, {a, b}).position, exact = point(m, a) + point(m, b);
    const double error = distance(x / norm(x), exact / norm(exact));
    CHECK(error < 0.5 * before);
    before = error;
  }
  CHECK(before < 0.005);
}

TEST_CASE("karcher_mean: work on an archetype") {
  const polygonmesh m = square_or_cube<polygonmesh>(3);
  const auto weak = only_embedded_mesh(m);
  const vec3 x = karcher_mean(weak, {weak.vert(vert_id{0}), weak.vert(vert_id{7})}).position;
  CHECK(distance(x, (point(m, vert_id{0}) + point(m, vert_id{7})) / 2) < 1e-9);
}

TEST_CASE("karcher_mean: throw if an argument is invalid") {
  const trimesh m(two_grids_arrays<trimesh>(2));
  CHECK_THROWS_WITH_AS(karcher_mean(m, {vert_id{0}, vert_id{99}}), "karcher_mean: a vert is not one of the mesh; take it from verts(m)", invalid_mesh);
  CHECK_THROWS_WITH_AS(karcher_mean(m, std::vector<vert_id>()), doctest::Contains("karcher_mean: there is no vert with a weight above 0"), invalid_argument);
  CHECK_THROWS_WITH_AS(karcher_mean(m, {{vert_id{1}, -1.0}}), "karcher_mean: the weight of vert 1 is -1; it has to be finite and not negative", invalid_argument);
  CHECK_THROWS_WITH_AS(karcher_mean(m, {vert_id{0}, vert_id{9}}), "karcher_mean: no path leads from vert 0 to vert 9; take verts of one component", invalid_argument);
}
