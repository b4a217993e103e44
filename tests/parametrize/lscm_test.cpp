// Conformal maps of disks: lscm and spectral_conformal. Developable surfaces, laws, motions, fixed verts, bad input.
#include <concino/parametrize/lscm.hpp>
#include <concino/parametrize/spectral_conformal.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/parametrize/map_distortion.hpp>

#include <support/motions.hpp>
#include <support/uv_disks.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// The largest change of a distance between verts, of an isometry to the plane.
template<class M, class U>
double edge_error(const M& m, const U& uv) {
  double worst = 0;
  for (const auto e : edges(m)) {
    const auto [a, b] = end_verts(m, e);
    const double d = distance(to_vec3(point(m, a)), to_vec3(point(m, b)));
    worst = std::max(worst, std::abs(std::hypot(uv[a][0] - uv[b][0], uv[a][1] - uv[b][1]) / d - 1));
  }
  return worst;
}

/// The energy of lscm per area.
template<class M, class U>
double conformal_energy_of(const M& m, const U& uv) {
  detail::polys_of_mesh<M, detail::flat_polys> read(m);
  const detail::poly_triangles cut(read.flat);
  double sum = 0, area = 0;
  for (const auto& t : cut.triangles) {
    const auto at = [&](std::size_t k) { return uv[read.verts[read.flat.corners[t.corner[k]]]]; };
    const auto [large, small] = detail::singular_values(t.derivative(at(0), at(1), at(2)));
    sum += t.area * (large - small) * (large - small);
    area += t.area * std::abs(large * small);
  }
  return sum / area;
}

}  // namespace

TEST_CASE_TEMPLATE("lscm, spectral_conformal: planar disks are mapped by a similarity, developable ones by an isometry", M, CONCINO_ALL_SURFACE_KINDS) {
  const auto check = [](const M& m) {
    const auto a = lscm(m);
    CHECK(edge_error(m, a) < 1e-10);
    CHECK(map_distortion(m, a).flipped == 0);
    const auto b = spectral_conformal(m);
    CHECK(edge_error(m, b) < 1e-8);
    for (const auto v : verts(m)) CHECK(std::hypot(a[v][0] - b[v][0], a[v][1] - b[v][1]) < 1e-8);  // placed and turned alike
  };
  for (const double slope : {0.0, 0.5}) check(grid_on<M>(8, [&](double x, double y) { return rotated(vec3{x + slope * y * y, 3 * y + slope * x * y, 0}); }));
  if constexpr (!std::is_same_v<M, polygonmesh>) {  // its larger polys are bent
    check(grid_on<M>(8, on_cylinder));
    check(grid_on<M>(8, on_cone));
  }
  const M m = grid_on<M>(4, [](double x, double y) { return vec3{x, 2 * y, 0}; });
  const auto only = only_embedded_mesh(m);
  CHECK(edge_error(only, lscm(only)) < 1e-10);
  CHECK(edge_error(only, spectral_conformal(only)) < 1e-8);
}

TEST_CASE("lscm: of random polygons in the plane") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    const auto m = random_polygons(seed, 5 + 20 * seed, false);
    CHECK(edge_error(m, lscm(m)) < 1e-7);  // some edges are very short
    CHECK(map_distortion(m, lscm(m)).max_angle < 1e-5);
  }
}

TEST_CASE_TEMPLATE("lscm, spectral_conformal: the smallest energy", M, CONCINO_ALL_SURFACE_KINDS) {
  const M m = grid_on<M>(6, on_hill);
  const auto uv = lscm(m);
  const double energy = conformal_energy_of(m, uv);
  CHECK(energy > 1e-4);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> amount(-1e-3, 1e-3);
  for (int round = 0; round < 50; ++round) {
    auto other = uv;
    // The two fixed verts are those at the ends of the x axis.
    for (const auto v : verts(m))
      if (!(uv[v] == uv_point{0, 0}) && std::abs(uv[v][1]) > 1e-12) other[v] = {uv[v][0] + amount(random), uv[v][1] + amount(random)};
    CHECK(conformal_energy_of(m, other) > energy * 0.99);
  }
  CHECK(map_distortion(m, uv).scale == doctest::Approx(1).epsilon(1e-9));
  const auto spectral = spectral_conformal(m);
  CHECK(map_distortion(m, spectral).scale == doctest::Approx(1).epsilon(1e-9));
  CHECK(map_distortion(m, spectral).flipped == 0);
  CHECK(conformal_energy_of(m, spectral) < 2 * energy);
}

TEST_CASE_TEMPLATE("lscm, spectral_conformal: rotations, scales and numbers of verts do not matter", M, CONCINO_ALL_SURFACE_KINDS) {
  auto arrays = grid_arrays<M>(5);
  for (vec3& x : arrays.points) x = on_hill(x.x, x.y);
  const M m(arrays), turned(rotated(arrays)), large(scaled(arrays, std::ldexp(1.0, 300))), tiny(scaled(arrays, std::ldexp(1.0, -400)));
  const auto n = static_cast<unsigned>(arrays.points.size());
  const M other(numbered_backwards(arrays));
  const auto check = [&](const auto& map, double accuracy) {
    const auto a = map(m), b = map(turned), c = map(large), d = map(tiny), e = map(other);
    for (const auto v : verts(m))
      for (std::size_t k = 0; k < 2; ++k) {
        CHECK(std::abs(b[v][k] - a[v][k]) < accuracy);
        CHECK(c[v][k] == std::ldexp(a[v][k], 300));
        CHECK(d[v][k] == std::ldexp(a[v][k], -400));
        CHECK(std::abs(e[vert_id{n - 1 - v.raw()}][k] - a[v][k]) < accuracy);
      }
  };
  check([](const M& x) { return lscm(x); }, 1e-9);
  check([](const M& x) { return spectral_conformal(x); }, 1e-7);
}

TEST_CASE("lscm: fixed verts keep their places") {
  const auto m = grid_on<quadmesh>(5, on_hill);
  const vert_id a{0}, b{5}, c{17};
  const auto uv = lscm(m, {{a, {1.0, 2.0}}, {b, {4.0, 6.0}}, {c, {3.0, 7.0}}});
  CHECK(uv[a] == uv_point{1, 2});
  CHECK(uv[b] == uv_point{4, 6});
  CHECK(uv[c] == uv_point{3, 7});
  std::vector<std::pair<vert_id, uv_point>> all;
  for (const auto v : verts(m)) all.push_back({v, {point(m, v).x, point(m, v).y}});
  CHECK(lscm(m, all)[c] == uv_point{point(m, c).x, point(m, c).y});
  const auto plane = grid<trimesh>(4);
  const auto same = lscm(plane, {{vert_id{0}, {0.0, 0.0}}, {vert_id{4}, {0.0, 2.0}}});
  for (const auto v : verts(plane)) {
    CHECK(same[v][0] == doctest::Approx(-2 * point(plane, v).y).epsilon(1e-10).scale(1));
    CHECK(same[v][1] == doctest::Approx(2 * point(plane, v).x).epsilon(1e-10).scale(1));
  }
  CHECK_THROWS_AS((void)lscm(m, {{a, {1.0, 2.0}}}), invalid_argument);
  CHECK_THROWS_AS((void)lscm(m, {{a, {1.0, 2.0}}, {a, {1.0, 2.0}}}), invalid_argument);
  CHECK_THROWS_AS((void)lscm(m, {{a, {1.0, 2.0}}, {b, {1.0, std::numeric_limits<double>::infinity()}}}), invalid_argument);
  CHECK_THROWS_AS((void)lscm(m, {{a, {1.0, 2.0}}, {vert_id{999}, {1.0, 2.0}}}), invalid_mesh);
}

TEST_CASE("lscm, spectral_conformal: all disks of the corpus, and bad input") {
  for_each_corpus_disk([](const std::string& name, const auto& m) {
    CAPTURE(name);
    const auto d = map_distortion(m, lscm(m)), s = map_distortion(m, spectral_conformal(m));
    CHECK(d.mean_angle < 0.5);
  });
  const trimesh ball({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  CHECK_THROWS_AS((void)lscm(ball), invalid_mesh);
  CHECK_THROWS_AS((void)spectral_conformal(ball), invalid_mesh);
  const trimesh flat({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  CHECK_THROWS_WITH_AS((void)lscm(flat),
                       "lscm: poly 0 has no area; repair(m, {.degenerate = degenerate_elements::collapse}) removes such triangles", invalid_mesh);
  CHECK_THROWS_AS((void)spectral_conformal(flat), invalid_mesh);
  const polygonmesh none;
  CHECK_THROWS_AS((void)lscm(none), invalid_mesh);
  CHECK_THROWS_AS((void)spectral_conformal(none), invalid_mesh);
  // A vert in the middle of an edge of a triangle is no degenerate triangle.
  const quadmesh middle({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 1, 2, 3}});
  CHECK(edge_error(middle, lscm(middle)) < 1e-12);
  const trimesh one({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}});
  CHECK(edge_error(one, lscm(one)) < 1e-12);
  CHECK(edge_error(one, spectral_conformal(one)) < 1e-8);
  CHECK_THROWS_AS((void)lscm(one, {.progress = [](double, const char*) { return false; }}), cancelled);
  CHECK_THROWS_AS((void)spectral_conformal(one, {.progress = [](double, const char*) { return false; }}), cancelled);
}
