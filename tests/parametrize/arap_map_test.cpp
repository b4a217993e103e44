// Maps of disks that are as rigid as possible: developable surfaces, energies that fall, motions, fixed verts, bad input.
#include <concino/parametrize/arap_map.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/parametrize/lscm.hpp>
#include <concino/parametrize/map_distortion.hpp>

#include <support/motions.hpp>
#include <support/uv_disks.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("arap_map: developable surfaces are mapped by an isometry, whatever the polys", M, CONCINO_ALL_SURFACE_KINDS) {
  const auto check = [](const M& m) {
    const auto r = arap_map(m);
    CHECK(map_distortion(m, r.uv).max_stretch == doctest::Approx(1).epsilon(1e-9));
    CHECK(map_distortion(m, r.uv).flipped == 0);
    CHECK(r.energies.back() < 1e-18);
    CHECK(r.has_converged);
  };
  check(grid_on<M>(6, [](double x, double y) { return rotated(vec3{x + 0.5 * y * y, 3 * y, 0}); }));
  if constexpr (!std::is_same_v<M, polygonmesh>) {
    check(grid_on<M>(8, on_cylinder));
    check(grid_on<M>(8, on_cone));
  }
}

TEST_CASE_TEMPLATE("arap_map: the energy falls in every iteration, and areas are kept better than by lscm", M, CONCINO_ALL_SURFACE_KINDS) {
  const M m = grid_on<M>(8, on_hill);
  const auto r = arap_map(m);
  CHECK(r.has_converged);
  REQUIRE(r.energies.size() > 3);
  for (std::size_t i = 1; i < r.energies.size(); ++i) CHECK(r.energies[i] <= r.energies[i - 1]);
  const auto before = map_distortion(m, lscm(m)), after = map_distortion(m, r.uv);
  CHECK(after.max_area / after.min_area < before.max_area / before.min_area);
  CHECK(after.flipped == 0);
  CHECK(arap_map(m, {.max_iterations = 0}).energies.size() == 1);
  CHECK(arap_map(m, {.max_iterations = 2, .tolerance = 0}).energies.size() == 3);
  CHECK(!arap_map(m, {.max_iterations = 2, .tolerance = 0}).has_converged);
  const auto only = only_embedded_mesh(m);
  CHECK(arap_map(only).energies == r.energies);
}

TEST_CASE("arap_map: rotations, scales and numbers of verts do not matter") {
  check_motions_and_numbers([](const trimesh& m) { return arap_map(m); }, 1e-8);
}

TEST_CASE("arap_map: fixed verts, all disks of the corpus, and bad input") {
  const auto m = grid_on<quadmesh>(5, on_hill);
  const auto r = arap_map(m, {{vert_id{0}, {1.0, 2.0}}, {vert_id{5}, {1.0, 3.5}}});
  CHECK(r.uv[vert_id{0}] == uv_point{1, 2});
  CHECK(r.uv[vert_id{5}] == uv_point{1, 3.5});
  for (std::size_t i = 1; i < r.energies.size(); ++i) CHECK(r.energies[i] <= r.energies[i - 1]);
  std::vector<std::pair<vert_id, uv_point>> all;
  for (const auto v : verts(m)) all.push_back({v, {point(m, v).x, point(m, v).y}});
  CHECK(arap_map(m, all).has_converged);
  for_each_corpus_disk([](const std::string& name, const auto& disk) {
    CAPTURE(name);
    const auto some = arap_map(disk, {.max_iterations = 20});
    for (std::size_t i = 1; i < some.energies.size(); ++i) CHECK(some.energies[i] <= some.energies[i - 1]);
    const auto d = map_distortion(disk, some.uv);
  });
  CHECK_THROWS_AS((void)arap_map(m, {{vert_id{0}, {1.0, 2.0}}}), invalid_argument);
  CHECK_THROWS_AS((void)arap_map(m, {.max_iterations = -1}), invalid_argument);
  CHECK_THROWS_AS((void)arap_map(m, {.tolerance = std::numeric_limits<double>::quiet_NaN()}), invalid_argument);
  CHECK_THROWS_AS((void)arap_map(m, {.progress = [](double, const char*) { return false; }}), cancelled);
  const trimesh flat({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  CHECK_THROWS_AS((void)arap_map(flat), invalid_mesh);
  const polygonmesh none;
  CHECK_THROWS_AS((void)arap_map(none), invalid_mesh);
}
