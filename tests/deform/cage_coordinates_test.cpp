#include <concino/deform/cage_coordinates.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/views/with_points.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/io/obj.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/quadmesh.hpp>
#include <concino/mesh/trimesh.hpp>

#include <support/closed_surfaces.hpp>
#include <support/corpus.hpp>
#include <support/kinds.hpp>
#include <support/motions.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <numeric>
#include <random>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

polygonmesh polygons_of(const surface_arrays& a) { return polygonmesh(with_offsets(a)); }

/// A prism over a concave arrow, whose bottom and top are polygons of four corners that a point between them does not see.
polygonmesh arrow() {
  return polygonmesh({{0, 0, 0}, {2, -1, 0}, {0.5, 0, 0}, {2, 1, 0}, {0, 0, 1}, {2, -1, 1}, {0.5, 0, 1}, {2, 1, 1}},
                     {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}

/// Cages of size near 1 to 5: convex, concave, with a hole, of polygons that are not planar.
std::vector<polygonmesh> cages() {
  std::vector<polygonmesh> all;
  all.push_back(polygons_of(voxel_skin({{0, 0, 0}})));
  all.push_back(polygons_of(voxel_skin({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})));
  all.push_back(polygons_of(holed_board(2)));
  all.push_back(arrow());
  const auto ball = icosphere(1);
  surface_arrays a;
  for (const auto v : verts(ball)) a.points.push_back(point(ball, v));
  a.offsets.push_back(0);
  for (const auto p : polys(ball)) {
    for (const auto v : adj_p2v(ball, p)) a.verts.push_back(v);
    a.offsets.push_back(static_cast<std::uint32_t>(a.verts.size()));
  }
  all.push_back(polygonmesh(a));
  auto twisted = with_offsets(voxel_skin({{0, 0, 0}, {0, 0, 1}}));
  for (vec3& x : twisted.points) x = rotated(vec3{x.x * std::cos(x.z) - x.y * std::sin(x.z), x.x * std::sin(x.z) + x.y * std::cos(x.z), x.z});
  all.push_back(polygonmesh(twisted));
  return all;
}

double size_of(const polygonmesh& m) {
  double size = 0;
  for (const auto v : verts(m))
    for (const auto w : verts(m)) size = std::max(size, distance(point(m, v), point(m, w)));
  return size;
}

/// Largest distance of the points reproduced from the points, and difference of the sum of weights from 1.
double error_of(const polygonmesh& cage, const std::vector<vec3>& points) {
  const auto w = cage_coordinates(cage, points);
  const auto again = w.points_of(cage);
  double worst = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto row = w.of(i);
    worst = std::max({worst, distance(points[i], again[i]), std::abs(std::accumulate(row.begin(), row.end(), 0.0) - 1)});
  }
  return worst;
}

}  // namespace

TEST_CASE("cage_coordinates: reproduce linear functions in and around cages, and near and on their verts, edges and polys") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> in(-1.0, 1.0), part(0.0, 1.0);
  for (const auto& cage : cages()) {
    const double size = size_of(cage);
    std::vector<vec3> box, near;
    vec3 centre;
    for (const auto v : verts(cage)) centre += point(cage, v) / static_cast<double>(num_verts(cage));
    for (int i = 0; i < 2000; ++i) box.push_back(centre + vec3{in(random), in(random), in(random)} * (size * (i % 2 ? 0.5 : 2.0)));
    for (const auto p : polys(cage)) {
      std::vector<vec3> corners;
      for (const auto v : adj_p2v(cage, p)) corners.push_back(point(cage, v));
      for (double d = 1e-3; d > 1e-17; d /= 10)
        for (int k = 0; k < 3; ++k) {
          const vec3 u = vec3{in(random), in(random), in(random)} * d;
          const double t = part(random), s = part(random) * (1 - t);
          near.push_back(corners[0] + u);
          near.push_back(corners[0] + t * (corners[1] - corners[0]) + u);
          near.push_back(corners[0] + t * (corners[1] - corners[0]) + s * (corners[2] - corners[0]) + u);
          near.push_back(corners[0] + 2 * (corners[1] - corners[0]) + 0.3 * (corners[2] - corners[1]) + u);  // in the plane of the poly, beyond it
          near.push_back(corners[0] - 0.5 * (corners[1] - corners[0]) + u);                                   // in line with an edge
        }
    }
    const double far_error = error_of(cage, box), near_error = error_of(cage, near);
    MESSAGE("errors of linear functions: " << far_error << ", near: " << near_error << ", of size " << size);
    CHECK(far_error <= 1e-12 * size);
    CHECK(near_error <= 1e-9 * size);
  }
}

TEST_CASE("cage_coordinates: those of a tet are barycentric, and positive in convex cages") {
  const trimesh tet({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  for (const vec3 x : {vec3{0.1, 0.2, 0.3}, vec3{0.25, 0.25, 0.25}, vec3{0.01, 0.9, 0.02}}) {
    const auto w = cage_coordinates(tet, std::vector<vec3>{x});
    CHECK(w.num_points() == 1);
    CHECK(w.num_cage_verts() == 4);
    CHECK(w.of(0)[0] == doctest::Approx(1 - x.x - x.y - x.z).epsilon(1e-12));
    CHECK(w.of(0)[1] == doctest::Approx(x.x).epsilon(1e-12));
    CHECK(w.of(0)[3] == doctest::Approx(x.z).epsilon(1e-12));
  }
  const auto ball = icosphere(2);
  const auto w = cage_coordinates(ball, std::vector<vec3>{{0.3, 0.2, -0.5}, {0, 0, 0}, {0.8, 0, 0.1}});
  for (std::size_t i = 0; i < 3; ++i)
    for (const double x : w.of(i)) CHECK(x > 0);
  // At the centre of a cube the corners are equal, on a square face its four are.
  const auto cube = polygons_of(voxel_skin({{0, 0, 0}}));
  const auto c = cage_coordinates(cube, std::vector<vec3>{{0.5, 0.5, 0.5}, {0.5, 0.5, 0}, {0, 0, 0}, {0.25, 0, 0}});
  for (const double x : c.of(0)) CHECK(x == doctest::Approx(0.125).epsilon(1e-13));
  for (const auto v : verts(cube)) {
    CHECK(c.of(1)[v.raw()] == doctest::Approx(point(cube, v).z == 0 ? 0.25 : 0).epsilon(1e-13));
    CHECK(c.of(2)[v.raw()] == (point(cube, v) == vec3{0, 0, 0} ? 1 : 0));
    CHECK(c.of(3)[v.raw()] == doctest::Approx(point(cube, v) == vec3{0, 0, 0} ? 0.75 : point(cube, v) == vec3{1, 0, 0} ? 0.25 : 0).epsilon(1e-13));
  }
}

TEST_CASE("cage_coordinates: are continuous at the cage") {
  for (const auto& cage : cages()) {
    std::vector<vec3> on, above, below;
    for (const auto p : polys(cage)) {
      std::vector<vec3> c;
      for (const auto v : adj_p2v(cage, p)) c.push_back(point(cage, v));
      const vec3 x = 0.8 * c[0] + 0.15 * c[1] + 0.05 * c[2], n = cross(c[1] - c[0], c[2] - c[0]);
      for (const vec3& y : {x, 0.6 * c[0] + 0.4 * c[1], c[0]}) on.push_back(y), above.push_back(y + 1e-7 * n), below.push_back(y - 1e-7 * n);
    }
    const auto w = cage_coordinates(cage, on), a = cage_coordinates(cage, above), b = cage_coordinates(cage, below);
    double worst = 0;
    for (std::size_t i = 0; i < on.size(); ++i)
      for (std::size_t k = 0; k < w.num_cage_verts(); ++k) worst = std::max({worst, std::abs(w.of(i)[k] - a.of(i)[k]), std::abs(w.of(i)[k] - b.of(i)[k])});
    CHECK(worst < 1e-4);
  }
}

TEST_CASE("cage_coordinates: depend neither on the scale, the orientation, nor the order of the cage") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> in(-1.0, 2.0);
  std::vector<vec3> points;
  for (int i = 0; i < 100; ++i) points.push_back({in(random), in(random), in(random)});
  const auto a = with_offsets(voxel_skin({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  const polygonmesh cage(a);
  const auto w = cage_coordinates(cage, points);
  const polygonmesh small(scaled(a, 0x1p-300));
  std::vector<vec3> small_points;
  for (const vec3& x : points) small_points.push_back(x * 0x1p-300);
  const auto s = cage_coordinates(small, small_points);
  surface_arrays back = a;
  for (std::size_t p = 0; p + 1 < a.offsets.size(); ++p)
    for (std::uint32_t k = a.offsets[p]; k < a.offsets[p + 1]; ++k) back.verts[k] = a.verts[a.offsets[p] + a.offsets[p + 1] - 1 - k];
  surface_arrays moved = a;  // corners begin elsewhere, polys are in another order
  std::reverse(moved.verts.begin(), moved.verts.end());
  for (std::size_t p = 0; p + 1 < a.offsets.size(); ++p) std::rotate(moved.verts.begin() + moved.offsets[p], moved.verts.begin() + moved.offsets[p] + 1, moved.verts.begin() + moved.offsets[p + 1]);
  const auto b = cage_coordinates(polygonmesh(back), points), o = cage_coordinates(polygonmesh(moved), points);
  double worst = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = 0; k < w.num_cage_verts(); ++k) {
      CHECK(w.of(i)[k] == s.of(i)[k]);
      worst = std::max({worst, std::abs(w.of(i)[k] - b.of(i)[k]), std::abs(w.of(i)[k] - o.of(i)[k])});
    }
  CHECK(worst < 1e-12);
}

TEST_CASE_TEMPLATE("cage_coordinates: move meshes of all kinds", M, CONCINO_ALL_KINDS) {
  const M m(grid_arrays<M>(2));
  auto cage = polygons_of(voxel_skin({{0, 0, 0}}));
  for (const auto v : verts(cage)) set_point(cage, v, 3 * point(cage, v) - vec3{1, 1, 1});
  const auto w = cage_coordinates(cage, m);
  CHECK(&w.mesh() == &m);
  auto bent = cage;
  for (const auto v : verts(bent)) set_point(bent, v, 2 * rotated(point(cage, v)) + vec3{1, 2, 3});
  const auto moved = w.points_of(bent);
  const auto g = only_embedded_mesh(m);
  const auto thin = only_embedded_mesh(cage);
  const auto on_archetypes = cage_coordinates(thin, g).points_of(only_embedded_mesh(bent));
  for (const auto v : verts(m)) {
    CHECK(distance(moved[v], 2 * rotated(point(m, v)) + vec3{1, 2, 3}) < 1e-12);
    CHECK(w.of(v).size() == 8);
  }
  for (const auto v : verts(g)) CHECK(distance(on_archetypes[v], 2 * rotated(to_vec3(point(g, v))) + vec3{1, 2, 3}) < 1e-12);
  CHECK(w.weights().num_points() == vert_index_bound(m));
}

TEST_CASE("cage_coordinates: of polygons") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> in(-4.0, 4.0);
  const std::vector<vec3> polygon{{0, 0, 7}, {2, -1, 2}, {0.5, 0, 0}, {2, 1, 0}, {1, 2, 0}};
  std::vector<vec3> points;
  for (int i = 0; i < 3000; ++i) points.push_back({in(random), in(random), 0});
  for (double d = 1e-3; d > 1e-17; d /= 10)
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const vec3 a = polygon[k], b = polygon[(k + 1) % polygon.size()];
      for (const double t : {-0.5, 0.0, 0.3, 1.5}) points.push_back({a.x + t * (b.x - a.x) + d * in(random), a.y + t * (b.y - a.y) + d * in(random), 0});
    }
  std::vector<vec3> flat = polygon;
  for (vec3& x : flat) x.z = 0;
  const auto w = cage_coordinates(polygon, points);
  const auto again = w.points_of(flat);
  double worst = 0, worst_near = 0;
  for (std::size_t i = 0; i < points.size(); ++i) (i < 3000 ? worst : worst_near) = std::max(i < 3000 ? worst : worst_near, distance(again[i], points[i]));
  CHECK(worst < 1e-12);
  CHECK(worst_near < 1e-9);
  // of a triangle barycentric; of a square at its centre equal
  const auto t = cage_coordinates(std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, std::vector<vec3>{{0.2, 0.3, 0}});
  CHECK(t.of(0)[1] == doctest::Approx(0.2).epsilon(1e-13));
  const auto s = cage_coordinates(std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, std::vector<vec3>{{0.5, 0.5, 0}});
  for (const double x : s.of(0)) CHECK(x == doctest::Approx(0.25).epsilon(1e-13));
  const quadmesh m(quad_grid(4));
  const auto moved = cage_coordinates(std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, m).points_of(std::vector<vec3>{{0, 0, 0}, {2, 0, 0}, {2, 2, 1}, {0, 2, 1}});
  for (const auto v : verts(m)) CHECK(distance(moved[v], {2 * point(m, v).x, 2 * point(m, v).y, point(m, v).y}) < 1e-12);
}

TEST_CASE("cage_coordinates: near those in the file of a rig") {
  const auto skin = corpus("skeletons/arm_rig/arm.obj"), cage_file = corpus("skeletons/arm_rig/arm_cage.obj"), file = corpus("skeletons/arm_rig/arm_cage_weights.txt");
  if (skin.empty() || cage_file.empty() || file.empty()) return skip("arm_rig is absent");
  const auto m = load_obj<trimesh>(skin);
  const auto cage = load_obj<trimesh>(cage_file);
  const auto w = cage_coordinates(cage, m);
  const auto same = w.points_of(cage);
  double size = 0, worst = 0;
  for (const auto v : verts(cage)) size = std::max(size, norm(point(cage, v) - point(cage, vert_id{0})));
  for (const auto v : verts(m)) CHECK(distance(same[v], point(m, v)) < 1e-12 * size);
  std::ifstream in(file);
  std::size_t c = 0, v = 0, n = 0, near = 0;
  double x = 0, sum = 0;
  while (in >> c >> v >> x) {
    const double d = std::abs(w.weights().of(v)[c] - x);
    worst = std::max(worst, d);
    sum += d;
    near += d < 0.01;
    ++n;
  }
  MESSAGE("weights of the rig: " << n << ", mean difference " << sum / static_cast<double>(n) << ", largest " << worst << ", " << near << " within 0.01");
  CHECK(n == num_verts(cage) * num_verts(m));
  CHECK(worst < 5e-6);  // the file has six digits
}

TEST_CASE("cage_coordinates: bad input") {
  const std::vector<vec3> x{{0.1, 0.1, 0.1}};
  const trimesh open({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}});
  CHECK_THROWS_WITH_AS((void)cage_coordinates(open, x), doctest::Contains("cage_coordinates: the cage is open or not consistently oriented at the edge of verts 0 and 2"), invalid_mesh);
  const trimesh turned({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  CHECK_THROWS_AS((void)cage_coordinates(turned, x), invalid_mesh);
  CHECK_THROWS_WITH_AS((void)cage_coordinates(trimesh(), x), "cage_coordinates: the cage has no polys", invalid_mesh);
  auto cage = polygons_of(voxel_skin({{0, 0, 0}}));
  CHECK_THROWS_WITH_AS((void)cage_coordinates(cage, std::vector<vec3>{{0, not_a_number, 0}}), "cage_coordinates: point 0 has a coordinate that is not finite", invalid_argument);
  CHECK_THROWS_WITH_AS((void)cage_coordinates(cage, std::vector<vec3>{{0, 0, 0}, {1e9, 0, 0}}), "cage_coordinates: point 1 is too far from the cage: its coordinates would not be accurate", invalid_argument);
  CHECK(cage_coordinates(cage, std::vector<vec3>()).num_points() == 0);
  CHECK(cage_coordinates(cage, std::vector<vec3>()).points_of(cage).empty());
  const auto w = cage_coordinates(cage, x);
  CHECK_THROWS_WITH_AS((void)w.points_of(icosphere(1)), doctest::Contains("points_of: the bent cage has 42 verts, and the cage had 8"), invalid_argument);
  CHECK_THROWS_AS((void)w.points_of(std::vector<vec3>{{0, 0, 0}}), invalid_argument);
  auto bent = cage;
  set_point(bent, vert_id{3}, vec3{not_a_number, 0, 0});
  CHECK_THROWS_WITH_AS((void)w.points_of(bent), "points_of: vert 3 has a coordinate that is not finite", invalid_mesh);
  CHECK_THROWS_AS((void)cage_coordinates(bent, x), invalid_mesh);
  for (const auto v : verts(bent)) set_point(bent, v, vec3{1, 1, 1});
  CHECK_THROWS_AS((void)cage_coordinates(bent, x), invalid_mesh);
  CHECK_THROWS_AS((void)cage_coordinates(std::vector<vec3>{{0, 0, 0}, {1, 0, 0}}, x), invalid_argument);
  CHECK_THROWS_AS((void)cage_coordinates(std::vector<vec3>{{0, 0, 0}, {0, 0, 1}, {0, 0, 2}}, x), invalid_argument);
  CHECK_THROWS_AS((void)cage_coordinates(std::vector<vec3>{{0, 0, 0}, {not_a_number, 0, 1}, {0, 1, 2}}, x), invalid_argument);
  // A deleted vert of the cage has weight 0, and a degenerate poly does no harm.
  const trimesh flat({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0, 0}}, {{0, 2, 1}, {0, 4, 3}, {4, 1, 3}, {0, 1, 4}, {1, 2, 3}, {2, 0, 3}});
  const auto f = cage_coordinates(flat, std::vector<vec3>{{0.1, 0.2, 0.3}, {0.3, 0, 0}, {3, 0, 0}, {0.5, 0, 0}, {0.5, 1e-9, 0}, {0.2, 0.2, -1}});
  CHECK(distance(f.points_of(flat)[0], {0.1, 0.2, 0.3}) < 1e-12);
  CHECK(distance(f.points_of(flat)[2], {3, 0, 0}) < 1e-9);
  CHECK(distance(f.points_of(flat)[4], {0.5, 1e-9, 0}) < 1e-9);
}
