#include <concino/fields/resample.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/core/error.hpp>
#include <concino/generate/icosphere.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <type_traits>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M>
auto values_at_verts(const M& m, double (*f)(const vec3&)) {
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = f(to_vec3(point(m, v)));
  return u;
}
double linear(const vec3& x) { return 2 * x.x - 3 * x.y + x.z + 1; }
double waves(const vec3& x) { return std::sin(5 * x.x) * std::cos(4 * x.y) + x.z * x.z; }

template<class M, class Q>
double integral(const M& m, const Q& q) {
  double sum = 0;
  for (const auto p : polys(m)) sum += q[p] * std::abs(measure(m, p));
  return sum;
}

template<class From, class To>
void check_vert_values(const From& from, const To& to) {
  const auto exact = resample(from, values_at_verts(from, linear), to);
  for (const auto v : verts(to)) CHECK(std::abs(exact[v] - linear(to_vec3(point(to, v)))) < 1e-12);
  const auto constant = resample(from, make_vert_map<double>(from, 0.1), to);
  for (const auto v : verts(to)) CHECK(constant[v] == 0.1);
  const auto u = values_at_verts(from, waves);
  const auto same = resample(from, u, from), copied = resample(from, u, from, vert_resampling::nearest);
  for (const auto v : verts(from)) {
    CHECK(std::abs(same[v] - u[v]) < 1e-12);
    CHECK(copied[v] == u[v]);
  }
}

template<class From, class To>
void check_poly_values(const From& from, const To& to) {
  auto q = make_poly_map<double>(from);
  for (const auto p : polys(from)) q[p] = waves(centroid(from, p));
  const auto r = resample(from, q, to);
  CHECK(std::abs(integral(to, r) - integral(from, q)) < 1e-12);
  const auto constant = resample(from, make_poly_map<double>(from, 3.0), to);
  for (const auto p : polys(to)) CHECK(constant[p] == doctest::Approx(3).epsilon(1e-10));
  const auto same = resample(from, q, from), copied = resample(from, q, from, poly_resampling::nearest);
  for (const auto p : polys(from)) {
    CHECK(same[p] == doctest::Approx(q[p]).epsilon(1e-10));
    CHECK(copied[p] == q[p]);
  }
}

}  // namespace

TEST_CASE("resample: linear functions are exact between surfaces, concave ones too; the mesh itself gets its values back") {
  const polygonmesh polygons(polygon_grid(3));
  const trimesh triangles(jittered(triangle_grid(4), 0, false));
  check_vert_values(polygons, triangles);
  check_vert_values(only_embedded_mesh(triangles), polygons);
}

TEST_CASE("resample: linear functions are exact between volumes; the mesh itself gets its values back") {
  const auto hexes = grid<hexmesh>(3);
  const auto tets = grid<tetmesh>(2);
  check_vert_values(hexes, tets);
  check_vert_values(tets, hexes);
  const auto plane = grid<trimesh>(2);
  const auto onto_surface = resample(hexes, values_at_verts(hexes, linear), plane);
  for (const auto v : verts(plane)) CHECK(std::abs(onto_surface[v] - linear(to_vec3(point(plane, v)))) < 1e-12);
}

TEST_CASE("resample: values of polys keep their integral, and constants stay, on the same domain") {
  check_poly_values(polygonmesh(polygon_grid(3)), grid<trimesh>(4));
  check_poly_values(grid<trimesh>(5), polygonmesh(polygon_grid(2)));
  check_poly_values(grid<tetmesh>(2), grid<hexmesh>(3));
  check_poly_values(grid<polyhedralmesh>(2), grid<tetmesh>(2));
}

TEST_CASE("resample: values of polys keep their integral on curved surfaces and on other domains, too") {
  const auto coarse = icosphere(2), fine = icosphere(3);
  auto q = make_poly_map<double>(coarse);
  for (const auto p : polys(coarse)) q[p] = 2 + centroid(coarse, p).x;
  const auto r = resample(coarse, q, fine);
  CHECK(integral(fine, r) == doctest::Approx(integral(coarse, q)).epsilon(1e-12));
  for (const auto p : polys(fine)) CHECK(std::abs(r[p] - 2 - centroid(fine, p).x) < 0.3);
  const trimesh far({{5, 5, 0}, {6, 5, 0}, {5, 6, 0}}, {{0, 1, 2}});
  const auto all = resample(coarse, q, far);
  CHECK(integral(far, all) == doctest::Approx(integral(coarse, q)).epsilon(1e-12));
}

TEST_CASE("resample: verts outside get the value at the closest point; meshes without polys and points that are not finite are refused") {
  const auto m = grid<trimesh>(2);
  const auto u = values_at_verts(m, linear);
  const trimesh beside({{0.25, -3, 0}, {0.5, 0.5, 7}, {9, 9, 0}}, {{0, 1, 2}});
  const auto r = resample(m, u, beside);
  CHECK(r[vert_id{0}] == doctest::Approx(linear({0.25, 0, 0})));
  CHECK(r[vert_id{1}] == doctest::Approx(linear({0.5, 0.5, 0})));
  CHECK(r[vert_id{2}] == doctest::Approx(linear({1, 1, 0})));
  const trimesh none;
  CHECK_THROWS_WITH_AS(resample(none, make_vert_map<double>(none), m), doctest::Contains("one of the meshes has no polys"), invalid_argument);
  CHECK_THROWS_AS(resample(m, make_poly_map<double>(m), none), invalid_argument);
  CHECK(resample(none, make_poly_map<double>(none), none).values().empty());
  CHECK(resample(m, u, none).values().empty());
  const trimesh broken({{0, 0, 0}, {1, 0, 0}, {0, std::nan(""), 0}}, {{0, 1, 2}});
  CHECK_THROWS_AS(resample(m, u, broken), invalid_argument);
  CHECK_THROWS_AS(resample(broken, make_vert_map<double>(broken), m), invalid_mesh);
  const trimesh thin({{0.1, 0.1, 0}, {0.2, 0.1, 0}, {0.3, 0.1, 0}}, {{0, 1, 2}});
  CHECK_THROWS_WITH_AS(resample(m, make_poly_map<double>(m, 1.0), thin), doctest::Contains("poly 0 of the new mesh has no area or volume"), invalid_mesh);
}
