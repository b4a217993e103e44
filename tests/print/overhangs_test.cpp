#include <concino/print/overhangs.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/generate/box.hpp>
#include <concino/generate/cone.hpp>
#include <concino/generate/sphere.hpp>
#include <concino/geometry/measure.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>
#include <support/motions.hpp>
#include <support/printed_parts.hpp>
#include <support/threads.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <vector>

using namespace concino;
using testing::letter_t;
using testing::voxel_part;

namespace {

constexpr double pi = 3.14159265358979323846;

/// x, turned about an axis that is not special.
vec3 turned(const vec3& x) { return testing::rotated(testing::rotated(x)); }

}  // namespace

TEST_CASE_TEMPLATE("overhangs: supports of a T and of a table in closed form, in any position", M, CONCINO_ALL_KINDS) {
  const auto check = [](const M& m, const vec3& up, double scale) {
    const auto t = overhangs(m, {.direction = up});
    CHECK(t.area == doctest::Approx(8 * scale * scale));  // 4 x 2 of the bar are beside the stem
    CHECK(t.support_volume == doctest::Approx(32 * scale * scale * scale).epsilon(1e-11));
    CHECK(t.contact_area == doctest::Approx(8 * scale * scale).epsilon(1e-11));
    CHECK(t.plate_area == doctest::Approx(4 * scale * scale));
    CHECK(t.height == doctest::Approx(5 * scale));
    CHECK(t.ignored.empty());
    double sum = 0;
    for (const auto& p : t.polys) {
      sum += area(m, p);
      CHECK(is_boundary(m, p) == VolumeMesh<M>);  // a face of one poly; of a closed surface no poly is at a border
    }
    CHECK(sum == doctest::Approx(t.area));
  };
  check(voxel_part<M>(letter_t()), {0, 0, 3}, 1);
  check(voxel_part<M>(letter_t(), turned), turned({0, 0, 1}), 1);
  check(voxel_part<M>(letter_t(), [](const vec3& x) { return 0x1p-400 * x; }), {0, 0, 1}, 0x1p-400);
  check(voxel_part<M>(letter_t(), [](const vec3& x) { return x + vec3{1000, -2000, 3000}; }), {0, 0, 1}, 1);

  const M table = voxel_part<M>(testing::table());
  const auto o = overhangs(table);
  CHECK(o.area == 16);
  CHECK(o.support_volume == doctest::Approx(48).epsilon(1e-13));
  CHECK(o.plate_area == 4);
  // upside down there is none; on its side, two legs stand and two hang
  CHECK(overhangs(table, {.direction = {0, 0, -1}}).polys.empty());
  CHECK(overhangs(table, {.direction = {0, 0, -1}}).plate_area == 20);
  const auto lying = overhangs(table, {.direction = {0, 1, 0}});
  CHECK(lying.area == 6);
  CHECK(lying.support_volume == doctest::Approx(12).epsilon(1e-13));  // down to the two lower legs
  CHECK(lying.contact_area == doctest::Approx(12).epsilon(1e-13));    // they stand on these
}

TEST_CASE("overhangs: the plate may be below the part") {
  const auto m = voxel_part<quadmesh>(letter_t());
  const auto o = overhangs(m, {.plate = -2});
  CHECK(o.plate == -2);
  CHECK(o.height == 7);
  CHECK(o.plate_area == 0);
  CHECK(o.area == 12);  // the foot hangs, too
  CHECK(o.support_volume == doctest::Approx(8 * 6 + 4 * 2));
  CHECK(overhangs(m, {.direction = {0, 0, 2}, .plate = 0}).plate_area == 4);
  CHECK(overhangs(m, {.direction = {0, 0, -1}}).plate == -5);
  CHECK_THROWS_WITH_AS(overhangs(m, {.plate = 0.5}), "overhangs: options.plate is above the lowest point of the part", invalid_argument);
}

TEST_CASE("overhangs: a sphere converges to the closed form") {
  // Within 45 degrees of straight down: a cap of area 2 pi (1 - cos 45). Its supports fill the cylinder below it, down to the plate at -1.
  const double rim = std::sqrt(0.5), cap_volume = pi * (1 - rim) * (1 - rim) * (2 + rim) / 3;
  const double expected = pi * rim * rim * (1 - rim) - cap_volume;
  double previous = 1;
  for (const std::size_t cells : {16u, 32u, 64u}) {
    const auto m = make_sphere<trimesh>({.cells = cells});
    const auto o = overhangs(m, {.plate = -1});
    const double error = std::abs(o.support_volume / expected - 1);
    CHECK(std::abs(o.area / (2 * pi * (1 - rim)) - 1) < 8.0 / static_cast<double>(cells));  // polys at the border of the cap are in or out
    CHECK(error < previous);
    previous = error;
  }
  CHECK(previous < 0.03);
}

TEST_CASE("overhangs: the limit is the angle from straight down, and polys at the limit are not included") {
  for (int angle = 5; angle < 90; angle += 5) {
    // a prism whose lower face is inclined: its normal is `angle` from straight down
    const double s = std::sin(angle * pi / 180), c = std::cos(angle * pi / 180);
    const polygonmesh m({{0, 0, 0}, {c, 0, s}, {c, 0, 3}, {0, 0, 3}, {0, 1, 0}, {c, 1, s}, {c, 1, 3}, {0, 1, 3}}, {{0, 1, 2, 3}, {7, 6, 5, 4}, {4, 5, 1, 0}, {5, 6, 2, 1}, {6, 7, 3, 2}, {7, 4, 0, 3}});
    CHECK(overhangs(m, {.max_angle_deg = angle + 1e-4}).polys == std::vector{poly_id{2}});
    CHECK(overhangs(m, {.max_angle_deg = double(angle)}).polys.empty());
    CHECK(overhangs(m, {.max_angle_deg = angle - 1e-4}).polys.empty());
    CHECK(overhangs(m, {.max_angle_deg = 90}).support_volume == doctest::Approx(0.5 * s * c));
  }
  CHECK(overhangs(voxel_part<quadmesh>(letter_t()), {.max_angle_deg = 0}).polys.empty());
  CHECK(overhangs(voxel_part<quadmesh>(letter_t(), turned), {.direction = turned({0, 0, 1}), .max_angle_deg = 90}).area == doctest::Approx(8));  // no walls
}

TEST_CASE("overhangs: supports end at the part, below coarse and fine polys") {
  // a plate above steps of different heights, all in one solid: a wall at the back joins them
  std::set<testing::voxel> v;
  testing::add_voxels(v, {0, 0, 10}, {8, 8, 11});
  testing::add_voxels(v, {0, 7, 0}, {8, 8, 10});
  double expected = 0;
  for (int i = 0; i < 8; ++i) {
    testing::add_voxels(v, {i, 0, 0}, {i + 1, 7, 1 + i % 5});
    expected += 7.0 * (10 - 1 - i % 5);
  }
  const auto m = voxel_part<quadmesh>(v);
  const auto o = overhangs(m);
  CHECK(o.area == 56);
  CHECK(o.support_volume == doctest::Approx(expected).epsilon(1e-13));
  CHECK(o.contact_area == doctest::Approx(112).epsilon(1e-13));
  // one large poly above a fine wave, as two surfaces in one mesh
  const unsigned n = 40;
  for (const double angle : {0.0, 0.3}) {
    surface_arrays a = testing::triangle_grid(n);
    const auto turn = [&](const vec3& x) { return vec3{std::cos(angle) * x.x - std::sin(angle) * x.y, std::sin(angle) * x.x + std::cos(angle) * x.y, x.z}; };
    double mean = 0;
    for (vec3& x : a.points) x.z = 0.2 * std::sin(7 * x.x) * std::sin(5 * x.y) + 0.3;
    for (std::size_t t = 0; t < a.verts.size(); t += 3) mean += (a.points[a.verts[t].raw()].z + a.points[a.verts[t + 1].raw()].z + a.points[a.verts[t + 2].raw()].z) / 3;
    mean /= static_cast<double>(a.verts.size() / 3);
    const auto first = static_cast<unsigned>(a.points.size());
    for (const vec3& x : {vec3{0, 0, 2}, vec3{0, 1, 2}, vec3{1, 1, 2}, vec3{1, 0, 2}}) a.points.push_back(x);
    for (const unsigned k : {0u, 1u, 2u, 0u, 2u, 3u}) a.verts.push_back(vert_id{first + k});
    for (vec3& x : a.points) x = turn(x);
    const auto wave = overhangs(trimesh(a));
    CHECK(wave.polys.size() == 2);
    CHECK(wave.support_volume == doctest::Approx(2 - mean).epsilon(1e-12));
    CHECK(wave.contact_area > 2);
  }
}

TEST_CASE("overhangs: long slender polys, parallel in any direction, are found fast") {
  // a lying pipe of radii 1 and 1/2 and length 8, of long quads; all of its lower polys within 45 degrees of straight down hang
  const unsigned n = testing::long_run() ? 50'000 : 4'000;
  const double last = 2 * pi / n, length = 8;
  double area = 0, volume = 0;  // per unit of length
  for (unsigned i = 0; i < n; ++i) {
    const double angle = (i + 1) * last;  // of the normal of quad i; corners at (i + 1/2) and (i + 3/2)
    const double y0 = std::cos(angle - last / 2), y1 = std::cos(angle + last / 2), z0 = std::sin(angle - last / 2), z1 = std::sin(angle + last / 2);
    if (-std::sin(angle) > std::cos((45 - 1e-6) * pi / 180)) {  // outside: down to the plate
      area += std::hypot(y1 - y0, z1 - z0);
      volume += std::abs(y1 - y0) * ((z0 + z1) / 2 + 2);
    }
    if (std::sin(angle) > std::cos((45 - 1e-6) * pi / 180)) {  // inside: down to the pipe, which is as far below the middle
      area += std::hypot(y1 - y0, z1 - z0) / 2;
      volume += std::abs(y1 - y0) / 2 * (z0 + z1) / 2;
    }
  }
  for (const double turn : {0.0, 0.4, 2.0}) {
    surface_arrays a{{}, {}, {}, 4};
    for (const double r : {1.0, 0.5})
      for (const double x : {0.0, length})
        for (unsigned i = 0; i < n; ++i) {
          const double y = r * std::cos((i + 0.5) * last);
          a.points.push_back({std::cos(turn) * x - std::sin(turn) * y, std::sin(turn) * x + std::cos(turn) * y, r * std::sin((i + 0.5) * last)});
        }
    const auto add = [&](unsigned v0, unsigned v1, unsigned v2, unsigned v3) {
      for (const unsigned v : {v0, v1, v2, v3}) a.verts.push_back(vert_id{v});
    };
    for (unsigned i = 0; i < n; ++i) {
      const unsigned j = (i + 1) % n;
      add(i, j, n + j, n + i);
      add(2 * n + i, 3 * n + i, 3 * n + j, 2 * n + j);
      add(i, 2 * n + i, 2 * n + j, j);
      add(n + i, n + j, 3 * n + j, 3 * n + i);
    }
    const auto o = overhangs(quadmesh(a), {.plate = -2});
    CHECK(o.area == doctest::Approx(area * length).epsilon(1e-9));
    CHECK(o.support_volume == doctest::Approx(volume * length).epsilon(1e-9));
  }
}

TEST_CASE("overhangs: agrees with the integral of rays on random solids") {
  std::mt19937 random(11);
  for (int round = 0; round < 20; ++round) {
    std::set<testing::voxel> v;
    testing::add_voxels(v, {0, 0, 0}, {5, 5, 1});
    for (int i = 0; i < 60; ++i) v.insert({static_cast<int>(random() % 5), static_cast<int>(random() % 5), static_cast<int>(random() % 6)});
    double volume = 0, area = 0;  // empty voxels with a full one somewhere above, down to a full one
    for (int i = 0; i < 5; ++i)
      for (int j = 0; j < 5; ++j)
        for (int k = 1; k < 7; ++k) {
          bool above = false;
          for (int l = k + 1; l < 7; ++l) above = above || v.count({i, j, l});
          volume += above && !v.count({i, j, k});
          area += v.count({i, j, k}) && !v.count({i, j, k - 1});
        }
    const auto o = overhangs(voxel_part<trimesh>(v));
    CHECK(o.area == doctest::Approx(area).epsilon(1e-13));
    CHECK(o.support_volume == doctest::Approx(volume).epsilon(1e-13));
    const auto turned_part = overhangs(voxel_part<trimesh>(v, turned), {.direction = turned({0, 0, 1})});
    CHECK(turned_part.support_volume == doctest::Approx(volume).epsilon(1e-11));
  }
}

TEST_CASE("overhangs: meshes of the user, archetypes, any number of threads") {
  const auto m = voxel_part<polygonmesh>(letter_t());
  const auto weak = only_embedded_mesh(m);
  CHECK(overhangs(weak).support_volume == doctest::Approx(32));
  CHECK(overhangs(weak).polys.size() == overhangs(m).polys.size());
  const auto solid = voxel_part<tetmesh>(letter_t());
  CHECK(overhangs(only_embedded_mesh(solid)).support_volume == doctest::Approx(32));
  user_mesh::surface own({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 2, 1}});
  CHECK(overhangs(own, {.plate = -1}).support_volume == doctest::Approx(0.5));
  const auto sphere = make_sphere<trimesh>({.cells = 24});
  const auto bits = [&](int threads) {
    const testing::with_num_threads now(threads);
    return overhangs(sphere, {.direction = {1, 2, 3}, .max_angle_deg = 60}).support_volume;
  };
  CHECK(bits(1) == bits(2));
  CHECK(bits(1) == bits(5));
}

TEST_CASE("overhangs: what has no area is named, what cannot be printed is refused") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  CHECK(overhangs(trimesh{}).area == 0);
  CHECK(overhangs(trimesh{}).height == 0);
  const trimesh flat({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {2, 0, 1}, {0, 0, -5}, {0, 0, -5}}, {{0, 2, 1}, {0, 1, 3}, {4, 5, 1}});
  const auto o = overhangs(flat, {.plate = 0});
  CHECK(o.ignored == std::vector{poly_id{1}, poly_id{2}});
  CHECK(o.polys == std::vector{poly_id{0}});
  CHECK(o.support_volume == 0.5);
  for (const double bad : {nan, infinite}) {
    const trimesh m({{0, 0, 0}, {1, 0, 0}, {0, bad, 0}}, {{0, 1, 2}});
    CHECK_THROWS_WITH_AS(overhangs(m), "overhangs: vert 2 is not finite", invalid_mesh);
    CHECK_THROWS_AS(overhangs(flat, {.direction = {0, 0, bad}}), invalid_argument);
    CHECK_THROWS_AS(overhangs(flat, {.max_angle_deg = bad}), invalid_argument);
    CHECK_THROWS_AS(overhangs(flat, {.plate = bad}), invalid_argument);
    CHECK_THROWS_AS(overhangs(flat, {.plate_tolerance = bad}), invalid_argument);
  }
  CHECK_THROWS_AS(overhangs(flat, {.direction = {0, 0, 0}}), invalid_argument);
  CHECK_THROWS_AS(overhangs(flat, {.max_angle_deg = -1}), invalid_argument);
  CHECK_THROWS_AS(overhangs(flat, {.max_angle_deg = 91}), invalid_argument);
  const auto inside_out = voxel_part<quadmesh>(letter_t(), [](const vec3& x) { return vec3{x.x, x.y, -x.z}; });
  CHECK_THROWS_AS(overhangs(inside_out), invalid_mesh);
}
