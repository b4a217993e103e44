#include <concino/geometry/corner_angles.hpp>

#include <concino/concepts/archetypes.hpp>

#include <support/corpus_meshes.hpp>
#include <support/kinds.hpp>
#include <support/motions.hpp>
#include <support/random_meshes.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double pi = std::numbers::pi;

/// The sum of the angles of a polygon, and its number of corners.
template<class M, class X, class Loop>
std::pair<double, int> angle_sum(const M& m, const X& x, const Loop& loop) {
  double sum = 0;
  int n = 0;
  for (const vert_t<M> v : loop) {
    sum += corner_angle(m, x, v);
    ++n;
  }
  return {sum, n};
}

/// V - E + P, without isolated verts.
template<class M>
double euler_characteristic(const M& m) {
  double chi = static_cast<double>(num_polys(m)) - static_cast<double>(num_edges(m));
  for (const auto v : verts(m)) {
    const auto around = adj_v2p(m, v);
    if (around.begin() != around.end()) chi += 1;
  }
  return chi;
}

template<class M>
double total(const M& m, const vert_map<M, double>& x) {
  double sum = 0;
  for (const auto v : verts(m)) sum += x[v];
  return sum;
}

}  // namespace

TEST_CASE_TEMPLATE("corner_angle: the angles of a planar polygon sum to (n - 2) pi, convex or not", M, CONCINO_KINDS) {
  const auto arrays = grid_arrays<M>(2);
  for (const M& m : {M(arrays), M(rotated(arrays)), M(scaled(rotated(arrays), 0x1p-600)), M(scaled(rotated(arrays), 0x1p600))}) {
    const auto check = [&](const auto& x, const auto& loop) {
      const auto [sum, n] = angle_sum(m, x, loop);
      CHECK(sum == doctest::Approx((n - 2) * pi).epsilon(1e-12));
    };
    if constexpr (SurfaceMesh<M>)
      for (const auto p : polys(m)) check(p, adj_p2v(m, p));
    else
      for (const auto f : faces(m)) check(f, adj_f2v(m, f));
  }
}

TEST_CASE_TEMPLATE("corner_angle: does not depend on scale, and is the same on the archetype", M, CONCINO_KINDS) {
  const auto arrays = jittered(grid_arrays<M>(1), 0.05);
  const M m(arrays), twice(scaled(arrays, 2)), small(scaled(arrays, 0x1p-900)), large(scaled(arrays, 0x1p1020));
  const auto g = only_embedded_mesh(m);
  const auto check = [&](const auto& x, const auto& stripped, const auto& loop) {
    for (const auto v : loop) {
      const double angle = corner_angle(m, x, v);
      CHECK(angle > 0);
      CHECK(angle < 2 * pi);
      CHECK(corner_angle(twice, x, v) == angle);
      CHECK(corner_angle(small, x, v) == doctest::Approx(angle).epsilon(1e-14));
      CHECK(corner_angle(large, x, v) == doctest::Approx(angle).epsilon(1e-14));
      CHECK(corner_angle(g, stripped, g.vert(v)) == doctest::Approx(angle).epsilon(1e-14));
    }
  };
  if constexpr (SurfaceMesh<M>)
    for (const auto p : polys(m)) check(p, g.poly(p), adj_p2v(m, p));
  else
    for (const auto f : faces(m)) check(f, g.face(f), adj_f2v(m, f));
}

TEST_CASE("corner_angle: is right for known corners") {
  const polygonmesh l({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}}, {{0, 1, 2, 3, 4, 5, 6}, {6, 5, 4, 3, 2, 1, 0}});
  for (const auto p : polys(l)) {
    CHECK(corner_angle(l, p, vert_id{0}) == doctest::Approx(pi / 2).epsilon(1e-15));
    CHECK(corner_angle(l, p, vert_id{3}) == doctest::Approx(3 * pi / 2).epsilon(1e-15));
    CHECK(corner_angle(l, p, vert_id{6}) == doctest::Approx(pi).epsilon(1e-15));
  }
  const trimesh needle({{0, 0, 0}, {1, 0, 0}, {1, 1e-160, 0}}, {{0, 1, 2}});
  CHECK(corner_angle(needle, poly_id{0}, vert_id{0}) == doctest::Approx(1e-160).epsilon(1e-14));
  const tetmesh corner({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}});
  for (const auto f : faces(corner))
    for (const auto v : adj_f2v(corner, f)) {
      const double angle = corner_angle(corner, f, v);
      const bool right = v == vert_id{0}, even = std::abs(normal(corner, f).x) == doctest::Approx(std::sqrt(1.0 / 3));
      CHECK(angle == doctest::Approx(right ? pi / 2 : even ? pi / 3 : pi / 4).epsilon(1e-15));
    }
}

TEST_CASE("corner_angle: is right for regular polygons, spikes and edges without length") {
  std::vector<vec3> x;
  std::vector<std::vector<int>> poly(1);
  for (int i = 0; i < 17; ++i) {
    x.push_back(rotated(vec3{std::cos(2 * pi * i / 17), std::sin(2 * pi * i / 17), 0}));
    poly[0].push_back(i);
  }
  const polygonmesh regular(x, poly);
  for (const auto v : verts(regular)) CHECK(corner_angle(regular, poly_id{0}, v) == doctest::Approx(15 * pi / 17).epsilon(1e-14));
  const polygonmesh spike({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 2, 0}, {0, 1, 0}}, {{0, 1, 3, 2, 4}});
  CHECK(corner_angle(spike, poly_id{0}, vert_id{3}) == 0);
  const double huge = std::numeric_limits<double>::max();
  const trimesh m({{2, 1, 5}, {2, 1, 5}, {2, 2, 5}, {-huge, 0, 0}, {huge, 0, 0}, {-huge, huge, 0}}, {{0, 1, 2}, {3, 4, 5}});
  for (const unsigned v : {0u, 1u, 2u}) CHECK(corner_angle(m, poly_id{0}, vert_id{v}) == 0);
  CHECK(corner_angle(m, poly_id{1}, vert_id{3}) == doctest::Approx(pi / 2));
  CHECK(corner_angle(m, poly_id{1}, vert_id{4}) == doctest::Approx(std::atan(0.5)));
}

TEST_CASE("corner_angle: throws for a vert of another poly, and is NaN for points that are not finite") {
  const trimesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, std::numeric_limits<double>::quiet_NaN(), 0}}, {{0, 1, 2}, {0, 1, 4}});
  CHECK_THROWS_WITH_AS(corner_angle(m, poly_id{0}, vert_id{3}), "corner_angle: vert 3 is not a vert of poly 0; take one of its own verts",
                       invalid_argument);
  const tetmesh t({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}});
  CHECK_THROWS_AS(corner_angle(t, face_id{0}, vert_id{3}), invalid_argument);
  CHECK(std::isnan(corner_angle(m, poly_id{1}, vert_id{0})));
}

TEST_CASE_TEMPLATE("angle_defects: on a flat grid are 0 inside and the turning angle on the boundary", M, CONCINO_SURFACE_KINDS) {
  const M m(rotated(two_grids_arrays<M>(3)));
  const auto defect = angle_defects(m);
  std::size_t turned = 0;
  for (const auto v : verts(m)) {
    CHECK((std::abs(defect[v]) < 1e-12 || defect[v] == doctest::Approx(pi / 2)));
    turned += defect[v] > 1;
  }
  CHECK(turned == 8);
  const M wild(jittered(grid_arrays<M>(3), 0.05));
  const auto g = only_embedded_mesh(wild);
  const auto expected = angle_defects(wild);
  const auto stripped = angle_defects(g);
  for (const auto v : verts(wild)) CHECK(stripped[g.vert(v)] == doctest::Approx(expected[v]).epsilon(1e-13));
  const M none;
  CHECK(angle_defects(none).values().empty());
}

TEST_CASE("angle_defects: sum to 2 pi times the Euler characteristic, also on non-manifold meshes") {
  std::mt19937 random(5);
  for (int i = 0; i < 40; ++i) {
    const auto m = random_mesh<trimesh>(random);
    CHECK(std::abs(total(m, angle_defects(m)) - 2 * pi * euler_characteristic(m)) < 1e-11);
  }
}

TEST_CASE("angle_defects: work on a user's mesh; an isolated vert has none") {
  const user_mesh::surface s = user_mesh::surface_example();
  const auto defect = angle_defects(s);
  CHECK(std::abs(total(s, defect) - 2 * pi) < 1e-12);
  CHECK(defect[user_mesh::vertex{0}] == doctest::Approx(-pi / 2));
  CHECK(defect[user_mesh::vertex{7}] == 0);
}

TEST_CASE("corpus: angle defects sum to 2 pi times the Euler characteristic, with known extremes") {
  struct row { const char* file; double chi, least, most; };
  const row rows[] = {{"tri/bunny.obj", 2, -0.754083067052, 0.702236407144},          {"tri/spot_textured.obj", 2, -0.438299057404, 0.65112323546},
                      {"tri/3holes.obj", -4, -0.234538314819, 0.196053499389},        {"tri/socket_genus7.off", -12, -1.96630839476, 1.89022096072},
                      {"tri/torus.obj", 0, -0.0510413901074, 0.0510402403452},        {"tri/two_spheres.obj", 4, 0.0164618011177, 0.0310595694828},
                      {"tri/maxFace_open.obj", 1, -1.47305139924, 1.32923396852},     {"tri/circle_disk.obj", 1, -2.22044604925e-15, 0.39269987625},
                      {"tri/sphere.obj", 2, -0.00119643168104, 0.0126555262203}};
  for (const row& r : rows) {
    INFO(r.file);
    const auto path = corpus(r.file);
    if (path.empty()) return skip(std::string("no corpus file ") + r.file);
    const auto m = load<trimesh>(path.string());
    const auto defect = angle_defects(m);
    CHECK(std::abs(total(m, defect) - 2 * pi * r.chi) < 1e-9);
    const auto [least, most] = std::minmax_element(defect.values().begin(), defect.values().end());
    CHECK(std::abs(*least - r.least) < 1e-9);
    CHECK(std::abs(*most - r.most) < 1e-9);
  }
}
