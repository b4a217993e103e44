#include <concino/deform/green_coordinates.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/views/with_points.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/io/obj.hpp>

#include <support/closed_surfaces.hpp>
#include <support/corpus.hpp>
#include <support/kinds.hpp>
#include <support/motions.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

vec3 moved(const vec3& x) { return 1.75 * rotated(x) + vec3{3, -4, 5}; }

trimesh el() { return trimesh(triangulated(voxel_skin({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}))); }

}  // namespace

TEST_CASE("green_coordinates: reproduce similarities in concave cages") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> in(0.0, 2.0);
  std::vector<vec3> points;
  while (points.size() < 500)
    if (const vec3 x{in(random), in(random), in(random) / 2}; x.x < 1 || x.y < 1) points.push_back(x);
  for (double d = 0.1; d > 1e-9; d /= 10) points.push_back({d, 0.3, 0.3}), points.push_back({d, d, 0.3}), points.push_back({d, d, d}), points.push_back({0.999, 1 - d, 0.5});
  const auto cage = el();
  auto bent = cage;
  for (const auto v : verts(bent)) set_point(bent, v, moved(point(cage, v)));
  auto inwards_arrays = triangulated(voxel_skin({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  for (std::size_t k = 0; k < inwards_arrays.verts.size(); k += 3) std::swap(inwards_arrays.verts[k], inwards_arrays.verts[k + 1]);
  const trimesh inwards(inwards_arrays);
  auto bent_inwards = inwards;
  for (const auto v : verts(inwards)) set_point(bent_inwards, v, moved(point(inwards, v)));
  const auto w = green_coordinates(cage, points);
  const auto same = w.points_of(cage), there = w.points_of(bent), turned = green_coordinates(inwards, points).points_of(bent_inwards);
  double worst = 0, near = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto row = w.of_verts(i);
    double& error = i < 500 ? worst : near;
    error = std::max({error, distance(same[i], points[i]), distance(there[i], moved(points[i])), distance(turned[i], moved(points[i])), std::abs(std::accumulate(row.begin(), row.end(), 0.0) - 1)});
  }
  MESSAGE("error of similarities: " << worst << ", nearer than 0.1: " << near);
  CHECK(worst < 1e-11);
  CHECK(near < 1e-6);
  CHECK(w.num_points() == points.size());
  CHECK(w.num_cage_polys() == num_polys(cage));
  CHECK(w.of_normals(0).size() == num_polys(cage));
}

TEST_CASE("green_coordinates: a stretched cage, and the integral of 1/r over a sphere") {
  // At the centre of a sphere of radius 1 the weights of normals add up to the mean of 1/r, 1.
  const auto ball = icosphere(4);
  const auto w = green_coordinates(ball, std::vector<vec3>{{0, 0, 0}});
  const auto row = w.of_normals(0);
  CHECK(std::accumulate(row.begin(), row.end(), 0.0) == doctest::Approx(1).epsilon(0.01));
  // They keep angles: in a cage that is stretched along x only, points get less stretch across it than coordinates of the verts give, by the factor of the normals.
  auto bent = ball;
  for (const auto v : verts(bent)) set_point(bent, v, vec3{2 * point(ball, v).x, point(ball, v).y, point(ball, v).z});
  const auto x = green_coordinates(ball, std::vector<vec3>{{0.1, 0, 0}, {0, 0.1, 0}}).points_of(bent);
  CHECK(x[0].x / 0.1 < 2);
  CHECK(x[1].y / 0.1 > 1);
}

TEST_CASE_TEMPLATE("green_coordinates: move meshes of all kinds", M, CONCINO_ALL_KINDS) {
  const M m(grid_arrays<M>(2));
  auto cage = el();
  for (const auto v : verts(cage)) set_point(cage, v, 4 * point(cage, v) - vec3{1, 1, 1});
  auto bent = cage;
  for (const auto v : verts(bent)) set_point(bent, v, moved(point(cage, v)));
  const auto g = only_embedded_mesh(m);
  const auto w = green_coordinates(cage, m);
  const auto x = w.points_of(bent);
  const auto y = green_coordinates(only_embedded_mesh(cage), g).points_of(only_embedded_mesh(bent));
  for (const auto v : verts(m)) CHECK(distance(x[v], moved(point(m, v))) < 1e-11);
  for (const auto v : verts(g)) CHECK(distance(y[v], moved(to_vec3(point(g, v)))) < 1e-11);
}

TEST_CASE("green_coordinates: the rig, whose skin leaves the cage where it is open") {
  const auto skin = corpus("skeletons/arm_rig/arm.obj"), cage_file = corpus("skeletons/arm_rig/arm_cage.obj");
  if (skin.empty() || cage_file.empty()) return skip("arm_rig is absent");
  const auto m = load_obj<trimesh>(skin);
  const auto cage = load_obj<trimesh>(cage_file);
  try {
    const auto w = green_coordinates(cage, m);
    const auto x = w.points_of(cage);
    double worst = 0;
    for (const auto v : verts(m)) worst = std::max(worst, distance(x[v], point(m, v)));
    CHECK(worst < 1e-9);
  } catch (const invalid_argument& e) {
    MESSAGE(e.what());
  }
}

TEST_CASE("green_coordinates: bad input") {
  const auto cage = el();
  const std::vector<vec3> x{{0.5, 0.5, 0.5}};
  for (const vec3 out : {vec3{1.5, 1.5, 0.5}, vec3{-1, 0, 0}, vec3{0, 0.5, 0.5}, vec3{0, 0, 0}, vec3{1e200, 0, 0}})
    CHECK_THROWS_WITH_AS((void)green_coordinates(cage, std::vector<vec3>{x[0], out}), "green_coordinates: point 1 is not inside of the cage; these coordinates are for points inside", invalid_argument);
  CHECK_THROWS_AS((void)green_coordinates(cage, std::vector<vec3>{{not_a_number, 0, 0}}), invalid_argument);
  CHECK_THROWS_WITH_AS((void)green_coordinates(quadmesh(voxel_skin({{0, 0, 0}})), x), "green_coordinates: poly 0 of the cage has 4 verts; pass to_triangles(cage)", unsupported);
  CHECK_THROWS_AS((void)green_coordinates(trimesh(triangle_grid(2)), x), invalid_mesh);
  CHECK_THROWS_AS((void)green_coordinates(trimesh(), x), invalid_mesh);
  const trimesh flat({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0, 0}}, {{0, 2, 1}, {0, 4, 3}, {4, 1, 3}, {0, 1, 4}, {1, 2, 3}, {2, 0, 3}});
  CHECK_THROWS_WITH_AS((void)green_coordinates(flat, std::vector<vec3>{{0.1, 0.1, 0.1}}), "green_coordinates: poly 3 of the cage has no area", invalid_mesh);
  const auto w = green_coordinates(cage, x);
  CHECK_THROWS_AS((void)w.points_of(icosphere(1)), invalid_argument);
  auto arrays = triangulated(voxel_skin({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  std::swap(arrays.verts[0], arrays.verts[1]);
  CHECK_THROWS_WITH_AS((void)w.points_of(trimesh(arrays)), doctest::Contains("the polys of the bent cage are not those of the cage"), invalid_argument);
  auto bent = cage;
  set_point(bent, vert_id{2}, vec3{not_a_number, 0, 0});
  CHECK_THROWS_AS((void)w.points_of(bent), invalid_mesh);
  CHECK(green_coordinates(cage, std::vector<vec3>()).points_of(cage).empty());
}
