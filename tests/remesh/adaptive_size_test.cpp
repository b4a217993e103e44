#include <concino/remesh/adaptive_size.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/end_verts.hpp>
#include <concino/convert/convert.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/geometry/edge_length.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/quadmesh.hpp>
#include <concino/mesh/trimesh.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

/// The side of a cylinder of radius 1 with its bottom, of quads and a polygon; or of the same points moved by move.
template<class Move>
polygonmesh open_cylinder(std::size_t around, std::size_t rows, double height, const Move& move) {
  std::vector<vec3> x;
  std::vector<std::vector<vert_id>> loops;
  for (std::size_t r = 0; r <= rows; ++r)
    for (std::size_t k = 0; k < around; ++k) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(around);
      x.push_back(move(vec3{std::cos(angle), std::sin(angle), height * static_cast<double>(r) / static_cast<double>(rows)}));
    }
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t k = 0; k < around; ++k) {
      const std::size_t a = r * around + k, b = r * around + (k + 1) % around;
      loops.push_back({vert_id{a}, vert_id{b}, vert_id{b + around}, vert_id{a + around}});
    }
  loops.emplace_back();
  for (std::size_t k = 0; k < around; ++k) loops.back().push_back(vert_id{around - 1 - k});
  return polygonmesh(x, loops);
}

template<class M, class Sizes>
std::array<double, 2> least_and_greatest(const M& m, const Sizes& sizes) {
  std::array<double, 2> r{no_limit, 0};
  for (const auto v : verts(m)) r = {std::min(r[0], sizes[v]), std::max(r[1], sizes[v])};
  return r;
}

}  // namespace

TEST_CASE_TEMPLATE("adaptive_size: a sphere needs the edges of an inscribed triangle", M, trimesh, polygonmesh) {
  for (const double radius : {1.0, 1e-160, 1e160}) {
    const auto m = convert<M>(icosphere(4, radius, {radius, 0, 0}));
    const double error = radius / 100;
    const auto sizes = adaptive_size(m, {.chord_error = error, .max_length = radius});
    const double want = std::sqrt(6 * 0.01 - 3 * 0.0001);
    const auto [least, greatest] = least_and_greatest(m, sizes);
    CHECK(least / radius == doctest::Approx(want).epsilon(1e-9));
    CHECK(greatest / radius == doctest::Approx(want).epsilon(1e-9));
  }
}

TEST_CASE("adaptive_size: a cylinder is curved as its circle, whatever the height of its polys") {
  const auto same = [](const vec3& x) { return x; };
  for (const double height : {0.5, 20.0}) {
    const auto m = open_cylinder(40, 5, height, same);
    const auto sizes = adaptive_size(m, {.chord_error = 0.001, .max_length = 9, .gradation = no_limit});
    const auto [least, greatest] = least_and_greatest(m, sizes);
    CHECK(least == doctest::Approx(std::sqrt(0.006 - 0.000003)));
    CHECK(greatest == doctest::Approx(least));
  }
}

TEST_CASE("adaptive_size: feature lines have their own curvature, and corners none") {
  std::vector<vec3> x{{0, 0, 0}};
  std::vector<std::vector<vert_id>> loops(1);
  for (std::size_t k = 0; k < 60; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / 60;
    x.push_back(vec3{2 * std::cos(angle), 2 * std::sin(angle), 0});
    loops[0].push_back(vert_id{k + 1});
  }
  const polygonmesh disc(x, loops);
  const auto sizes = adaptive_size(disc, {.chord_error = 0.01, .max_length = 5, .gradation = no_limit});
  CHECK(sizes[vert_id{0}] == 5);  // in no poly
  for (std::size_t k = 1; k <= 60; ++k) CHECK(sizes[vert_id{k}] == doctest::Approx(std::sqrt(8 * 0.01 * 2 - 4 * 0.0001)));

  const std::vector<vec3> corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const polygonmesh square(corners, std::vector<std::vector<vert_id>>{{vert_id{0}, vert_id{1}, vert_id{2}, vert_id{3}}});
  for (const auto v : verts(square)) CHECK(adaptive_size(square, {.chord_error = 0.01})[v] == doctest::Approx(std::sqrt(2.0) / 10));
}

TEST_CASE("adaptive_size: a cube is flat between its edges") {
  const polygonmesh cube(
      std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
      std::vector<std::vector<vert_id>>{{vert_id{0}, vert_id{3}, vert_id{2}, vert_id{1}}, {vert_id{4}, vert_id{5}, vert_id{6}, vert_id{7}},
                                        {vert_id{0}, vert_id{1}, vert_id{5}, vert_id{4}}, {vert_id{1}, vert_id{2}, vert_id{6}, vert_id{5}},
                                        {vert_id{2}, vert_id{3}, vert_id{7}, vert_id{6}}, {vert_id{3}, vert_id{0}, vert_id{4}, vert_id{7}}});
  const auto flat = adaptive_size(cube, {.chord_error = 0.001, .max_length = 0.3});
  const auto round = adaptive_size(cube, {.chord_error = 0.001, .max_length = 0.3, .feature_angle_deg = 180});
  for (const auto v : verts(cube)) {
    CHECK(flat[v] == 0.3);
    CHECK(round[v] < 0.1);
  }
}

TEST_CASE("adaptive_size: sizes grow no faster than the gradation, and only where that is needed") {
  const auto cone = open_cylinder(48, 30, 6, [](const vec3& x) {
    const double r = 0.02 + x.z * x.z / 12;
    return vec3{r * x.x, r * x.y, x.z};
  });
  const adaptive_size_options free{.chord_error = 0.002, .max_length = 2, .gradation = no_limit};
  adaptive_size_options limited = free;
  limited.gradation = 0.02;
  const auto before = adaptive_size(cone, free), after = adaptive_size(cone, limited);
  bool is_limited = false;
  for (const auto e : edges(cone)) {
    const auto [a, b] = end_verts(cone, e);
    CHECK(std::abs(after[a] - after[b]) <= 0.02 * edge_length(cone, e) * (1 + 1e-9));
    is_limited = is_limited || std::abs(before[a] - before[b]) > 0.02 * edge_length(cone, e);
  }
  CHECK(is_limited);
  CHECK(least_and_greatest(cone, after)[0] == least_and_greatest(cone, before)[0]);
  for (const auto v : verts(cone)) CHECK(after[v] <= before[v]);
}

TEST_CASE("adaptive_size: a smaller error never gives longer edges, within the limits") {
  const auto m = icosphere(2);
  double last = 0;
  for (const double error : {1e-6, 0.001, 0.1, 0.5, 0.9, 1.1, 3.0}) {
    const double least = least_and_greatest(m, adaptive_size(m, {.chord_error = error, .min_length = 0.05, .max_length = 4}))[0];
    CHECK(least >= last);
    CHECK(least >= 0.05);
    CHECK(least <= 4);
    last = least;
  }
}

TEST_CASE("adaptive_size: empty, degenerate and non-manifold surfaces") {
  const polygonmesh empty;
  CHECK_NOTHROW(adaptive_size(empty, {.chord_error = 1}));
  // Three triangles at one edge, of which one is wound the other way and one has no area.
  const std::vector<vec3> x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0.2}, {2, 0, 0}};
  const std::vector<std::vector<vert_id>> loops{{vert_id{0}, vert_id{1}, vert_id{2}}, {vert_id{0}, vert_id{1}, vert_id{3}}, {vert_id{0}, vert_id{1}, vert_id{4}}};
  const polygonmesh m(x, loops);
  const auto sizes = adaptive_size(m, {.chord_error = 0.01, .max_length = 0.5});
  for (const auto v : verts(m)) CHECK(sizes[v] == 0.5);
  const polygonmesh one_point(std::vector<vec3>(3, vec3{1, 2, 3}), std::vector<std::vector<vert_id>>{{vert_id{0}, vert_id{1}, vert_id{2}}});
  CHECK(adaptive_size(one_point, {.chord_error = 0.25})[vert_id{0}] == 0.25);
}

TEST_CASE("adaptive_size: needs no more than an embedded mesh") {
  const auto m = icosphere(2);
  const auto weakest = only_embedded_mesh(m);
  const adaptive_size_options options{.chord_error = 0.01, .max_length = 4};
  const auto native = adaptive_size(m, options);
  const auto sizes = adaptive_size(weakest, options);
  for (const auto v : verts(weakest)) CHECK(sizes[v] == doctest::Approx(native[vert_id{index_of(weakest, v)}]));
}

TEST_CASE("adaptive_size: errors") {
  const auto m = icosphere(0);
  CHECK_THROWS_AS(adaptive_size(m, {}), invalid_argument);
  CHECK_THROWS_AS(adaptive_size(m, {.chord_error = -1}), invalid_argument);
  CHECK_THROWS_AS(adaptive_size(m, {.chord_error = 1, .min_length = 2, .max_length = 1}), invalid_argument);
  CHECK_THROWS_AS(adaptive_size(m, {.chord_error = 1, .gradation = 0}), invalid_argument);
  CHECK_THROWS_AS(adaptive_size(m, {.chord_error = 1, .feature_angle_deg = -1}), invalid_argument);
  auto far = icosphere(0);
  set_point(far, vert_id{3}, vec3{0, no_limit, 0});
  CHECK_THROWS_AS(adaptive_size(far, {.chord_error = 1}), invalid_mesh);
}
