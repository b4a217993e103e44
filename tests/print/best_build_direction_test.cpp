#include <concino/print/best_build_direction.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/generate/box.hpp>
#include <concino/generate/cone.hpp>
#include <concino/generate/sphere.hpp>
#include <concino/generate/torus.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/print/overhangs.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>
#include <support/motions.hpp>
#include <support/printed_parts.hpp>
#include <support/threads.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <set>
#include <vector>

using namespace concino;
using testing::voxel_part;

namespace {

vec3 turned(const vec3& x) { return testing::rotated(testing::rotated(x)); }

/// A bracket without any symmetry.
std::set<testing::voxel> bracket() {
  std::set<testing::voxel> v;
  testing::add_voxels(v, {0, 0, 0}, {5, 3, 1});
  testing::add_voxels(v, {0, 0, 1}, {1, 3, 4});
  testing::add_voxels(v, {0, 0, 4}, {3, 1, 5});
  testing::add_voxels(v, {4, 2, 1}, {5, 3, 3});
  return v;
}

template<class M>
void check_result(const M& m, const build_direction_result<M>& d, const build_direction_options& options = {}) {
  CHECK(norm(d.direction) == doctest::Approx(1).epsilon(1e-14));
  const auto o = overhangs(m, {.direction = d.direction, .max_angle_deg = options.max_angle_deg});
  double a = 0;
  for_each_outer_polygon(m, [&](const auto&, const auto& loop, bool) { a += norm(area_vector_of(m, loop)); });
  CHECK(d.overhang_area == doctest::Approx(o.area));
  CHECK(d.support_volume == doctest::Approx(o.support_volume));
  CHECK(d.plate_area == doctest::Approx(o.plate_area));
  CHECK(d.height == doctest::Approx(o.height));
  CHECK(d.cost == doctest::Approx(options.overhang_weight * o.area / a + options.support_weight * o.support_volume / std::pow(a, 1.5) +
                                  options.height_weight * o.height / std::sqrt(a) + options.plate_weight * (1 - o.plate_area / a)));
}

}  // namespace

TEST_CASE_TEMPLATE("best_build_direction: a box stands on its largest face, a table on its top", M, CONCINO_KINDS) {
  std::set<testing::voxel> box;
  testing::add_voxels(box, {0, 0, 0}, {1, 2, 3});
  const M m = voxel_part<M>(box);
  const auto d = best_build_direction(m);
  check_result(m, d);
  CHECK(std::abs(d.direction.x) == doctest::Approx(1).epsilon(1e-12));
  CHECK(d.overhang_area == 0);
  CHECK(d.plate_area == doctest::Approx(6));
  const M t = voxel_part<M>(testing::table());
  const auto top = best_build_direction(t);
  check_result(t, top);
  CHECK(norm(top.direction - vec3{0, 0, -1}) < 1e-12);
  CHECK(top.support_volume == 0);
  CHECK(top.plate_area == doctest::Approx(20));
}

TEST_CASE_TEMPLATE("best_build_direction: turns with the part, and does not depend on its size and place", M, CONCINO_KINDS) {
  for (const auto& voxels : {bracket(), testing::table()}) {
    const M m = voxel_part<M>(voxels);
    const auto d = best_build_direction(m);
    check_result(m, d);
    const M moved = voxel_part<M>(voxels, [](const vec3& x) { return turned(x) + vec3{3, -70, 5}; });
    const auto other = best_build_direction(moved);
    check_result(moved, other);
    CHECK(other.cost == doctest::Approx(d.cost).epsilon(1e-9));
    CHECK(norm(other.direction - turned(d.direction)) < 1e-9);
    for (const double factor : {0x1p-300, 0x1p300}) {
      const auto scaled = best_build_direction(voxel_part<M>(voxels, [&](const vec3& x) { return factor * x; }));
      CHECK(scaled.cost == d.cost);
      CHECK(scaled.direction == d.direction);
      CHECK(scaled.height == factor * d.height);
    }
  }
}

TEST_CASE("best_build_direction: is better than any direction of a fine sample") {
  const std::vector<trimesh> parts{make_cone<trimesh>({.cells = 8}), make_torus<trimesh>({.cells = {12, 6}}), voxel_part<trimesh>(bracket(), turned)};
  const int samples = testing::long_run() ? 2000 : 100;
  for (const auto& m : parts) {
    std::vector<overhang_report<trimesh>> all;
    for (int i = 0; i < samples; ++i) {
      const double z = 2 * (i + 0.5) / samples - 1, r = std::sqrt(1 - z * z), phi = 2.399963229728653 * i;
      all.push_back(overhangs(m, {.direction = {r * std::cos(phi), r * std::sin(phi), z}}));
    }
    for (const build_direction_options& options : {build_direction_options{}, {.support_weight = 0}, {.height_weight = 0, .plate_weight = 0}, {.overhang_weight = 0, .height_weight = 1}}) {
      const auto d = best_build_direction(m, options);
      check_result(m, d, options);
      const double a = total_measure(m);
      double best = std::numeric_limits<double>::infinity();
      for (const auto& o : all)
        best = std::min(best, options.overhang_weight * o.area / a + options.support_weight * o.support_volume / std::pow(a, 1.5) +
                                  options.height_weight * o.height / std::sqrt(a) + options.plate_weight * (1 - o.plate_area / a));
      CHECK(d.cost <= best + 1e-9);
    }
  }
}

TEST_CASE("best_build_direction: a cone stands on its base, not on its tip, and costs of a sphere are those of the closed form") {
  const auto cone = make_cone<trimesh>({.cells = 8});
  CHECK(best_build_direction(cone).direction.z == doctest::Approx(1));
  const auto sphere = make_sphere<trimesh>({.cells = 6});
  const auto d = best_build_direction(sphere);
  check_result(sphere, d);
  CHECK(std::isfinite(d.cost));
  CHECK(d.overhang_area < 2 * 3.14159 * (1 - std::sqrt(0.5)) * 1.1);
}

TEST_CASE("best_build_direction: flat parts, archetypes, any number of threads, progress") {
  const quadmesh sheet = testing::grid<quadmesh>(3);  // seen from either side, one of which lies on the plate
  const auto flat = best_build_direction(sheet);
  check_result(sheet, flat);
  CHECK(flat.plate_area + flat.overhang_area <= 1 + 1e-12);
  const auto m = voxel_part<polygonmesh>(bracket());
  const auto weak = only_embedded_mesh(m);
  CHECK(best_build_direction(weak).direction == best_build_direction(m).direction);
  const auto bits = [&](int threads) {
    const testing::with_num_threads now(threads);
    const auto d = best_build_direction(m);
    return std::vector{d.direction.x, d.direction.y, d.direction.z, d.cost};
  };
  CHECK(bits(1) == bits(2));
  double last = -1;
  bool grows = true;
  best_build_direction(m, {.progress = [&](double fraction, const char*) {
    grows = grows && fraction >= last;
    last = fraction;
    return true;
  }});
  CHECK(grows);
  CHECK(last == 1);
  CHECK_THROWS_AS(best_build_direction(m, {.progress = [](double, const char*) { return false; }}), cancelled);
}

TEST_CASE("best_build_direction: ignores polys without an area and names them; refuses what it cannot use") {
  auto arrays = testing::with_offsets(testing::voxel_skin(bracket()));
  const auto clean = best_build_direction(polygonmesh(arrays));
  const auto first = static_cast<unsigned>(arrays.points.size());
  for (const vec3& x : {vec3{1, 1, 1}, vec3{2, 2, 2}, vec3{-30, -30, -30}}) arrays.points.push_back(x);
  for (unsigned k = 0; k < 3; ++k) arrays.verts.push_back(vert_id{first + k});
  arrays.offsets.push_back(static_cast<std::uint32_t>(arrays.verts.size()));
  const polygonmesh m(arrays);
  const auto d = best_build_direction(m);
  CHECK(d.ignored == std::vector{poly_id{num_polys(m) - 1}});
  CHECK(d.direction == clean.direction);
  CHECK(d.cost == doctest::Approx(clean.cost));
  CHECK_THROWS_WITH_AS(best_build_direction(trimesh{}), "best_build_direction: no poly has an area", invalid_mesh);
  CHECK_THROWS_AS(best_build_direction(trimesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}})), invalid_mesh);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(best_build_direction(trimesh({{0, 0, 0}, {1, 0, 0}, {2, nan, 0}}, {{0, 1, 2}})), invalid_mesh);
  for (const double bad : {nan, -1.0, std::numeric_limits<double>::infinity()}) {
    CHECK_THROWS_AS(best_build_direction(m, {.max_angle_deg = bad}), invalid_argument);
    CHECK_THROWS_AS(best_build_direction(m, {.overhang_weight = bad}), invalid_argument);
    CHECK_THROWS_AS(best_build_direction(m, {.support_weight = bad}), invalid_argument);
    CHECK_THROWS_AS(best_build_direction(m, {.height_weight = bad}), invalid_argument);
    CHECK_THROWS_AS(best_build_direction(m, {.plate_weight = bad}), invalid_argument);
    CHECK_THROWS_AS(best_build_direction(m, {.accuracy_deg = bad}), invalid_argument);
    CHECK_THROWS_AS(best_build_direction(m, {.plate_tolerance = bad}), invalid_argument);
  }
  CHECK_THROWS_AS(best_build_direction(m, {.samples = 0}), invalid_argument);
  CHECK_THROWS_AS(best_build_direction(m, {.samples = 101}), invalid_argument);
}
