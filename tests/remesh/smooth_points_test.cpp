#include <concino/remesh/smooth_points.hpp>

#include <concino/edit/flip_winding.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/geometry/bounding_tree.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/io/load_any.hpp>
#include <concino/mesh.hpp>
#include <concino/quality/worst.hpp>

#include <support/corpus_meshes.hpp>
#include <support/kinds.hpp>
#include <support/whole_mesh.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <variant>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// A grid whose inner verts are moved by up to `noise` of an edge, those of surfaces within their plane.
template<class M>
M noisy_grid(unsigned n, double noise, unsigned seed = 1) {
  auto m = grid<M>(n);
  std::mt19937 random(seed);
  const double edge = distance(point(m, vert_id{0}), point(m, vert_id{1}));
  const auto d = [&] { return noise * edge * (2 * std::ldexp(double(random()), -32) - 1); };
  for (const auto v : verts(m)) {
    const double x = d(), y = d(), z = dimension_v<M> == 3 ? d() : 0;
    if (!is_boundary(m, v)) set_point(m, v, point(m, v) + vec3{x, y, z});
  }
  return m;
}

template<class M>
void check_smoothing(const M& before, const M& m, const points_smoothing& r) {
  CHECK(r.min_shape_after >= r.min_shape_before);
  CHECK(r.num_inverted_after <= r.num_inverted_before);
  for (const auto v : verts(m))
    if (is_boundary(m, v)) CHECK(point(m, v) == point(before, v));
  std::size_t moved = 0;
  for (const auto v : verts(m)) moved += !(point(m, v) == point(before, v));
  CHECK((moved > 0) == (r.num_moves > 0));
}

}  // namespace

TEST_CASE_TEMPLATE("smooth_points: regular shapes come back", M, trimesh, quadmesh, tetmesh, hexmesh) {
  for (const double noise : {0.15, 0.3}) {
    const auto before = noisy_grid<M>(6, noise);
    auto m = before;
    const auto r = smooth_points(m);
    check_smoothing(before, m, r);
    CHECK(r.num_inverted_before == 0);
    // the best shapes of a right triangle and of a Kuhn tet, and of squares and cubes
    const double best = worst(grid<M>(6), metric::mean_ratio).value;
    CHECK(r.min_shape_after > 0.97 * best);
    CHECK(worst(m, metric::mean_ratio).value == doctest::Approx(r.min_shape_after).epsilon(1e-9));
    auto again = before;
    smooth_points(again);
    CHECK(whole(again) == whole(m));
    CHECK(total_measure(m) == doctest::Approx(total_measure(before)).epsilon(1e-12));
  }
}

TEST_CASE_TEMPLATE("smooth_points: inverted corners are turned back", M, trimesh, quadmesh, tetmesh, hexmesh) {
  for (const unsigned seed : {1u, 2u}) {
    const auto before = noisy_grid<M>(6, 0.6, seed);
    auto m = before;
    const auto r = smooth_points(m, {.feature_angle_deg = 180});
    check_smoothing(before, m, r);
    CHECK(r.num_inverted_before > 0);
    CHECK(r.num_inverted_after == 0);
    CHECK(worst(m, metric::scaled_jacobian).value > 0.3);
  }
}

TEST_CASE("smooth_points: regular polys stay as they are") {
  const auto is_ideal = [](auto m) {
    const auto r = smooth_points(m);
    CHECK(r.min_shape_before == doctest::Approx(1).epsilon(1e-12));
    CHECK(r.num_moves == 0);
  };
  is_ideal(tetmesh({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 1, 2, 3}}));
  is_ideal(grid<hexmesh>(2));
  is_ideal(grid<quadmesh>(2));
  const double s = std::sqrt(3.0) / 2;
  is_ideal(trimesh({{0, 0, 0}, {1, 0, 0}, {0.5, s, 0}}, {{0, 1, 2}}));
  std::vector<vec3> hexagon;
  for (int i = 0; i < 6; ++i) hexagon.push_back({std::cos(i * 1.0471975511965976), std::sin(i * 1.0471975511965976), 0});
  polygonmesh one(hexagon, std::vector<std::vector<unsigned>>{{0, 1, 2, 3, 4, 5}});
  is_ideal(one);
}

TEST_CASE("smooth_points: verts of a surface stay on it, and on its sharp edges") {
  auto m = icosphere(3);
  std::mt19937 random(5);
  for (const auto v : verts(m)) {
    const auto d = [&] { return 0.1 * (std::ldexp(double(random()), -32) - 0.5); };
    const double a = d(), b = d(), c = d();
    const vec3 x = point(m, v) + vec3{a, b, c};
    set_point(m, v, x / norm(x));
  }
  const auto before = m;
  const poly_tree<trimesh> tree(before);
  const auto r = smooth_points(m);
  check_smoothing(before, m, r);
  CHECK(r.min_shape_after > r.min_shape_before + 0.1);
  for (const auto v : verts(m)) CHECK(tree.closest(point(m, v)).distance < 1e-12);

  // a roof: verts at its ridge stay
  auto roof = noisy_grid<quadmesh>(8, 0.2);
  for (const auto v : verts(roof)) {
    vec3 x = point(roof, v);
    if (std::abs(x.x - 0.5) < 0.05) x.x = 0.5;
    set_point(roof, v, vec3{x.x, x.y, -2 * std::abs(x.x - 0.5)});
  }
  const auto old = roof;
  smooth_points(roof);
  unsigned num_at_ridge = 0, num_moved = 0;
  for (const auto v : verts(roof)) {
    num_moved += !(point(roof, v) == point(old, v));
    if (point(old, v).x != 0.5) continue;
    ++num_at_ridge;
    CHECK(point(roof, v) == point(old, v));
  }
  CHECK(num_at_ridge == 9);
  CHECK(num_moved > 20);
}

TEST_CASE_TEMPLATE("smooth_points: verts that the caller names stay", M, quadmesh, hexmesh) {
  const auto before = noisy_grid<M>(5, 0.3);
  auto m = before;
  const auto is_fixed = [](const vert_t<M>& v) { return v.raw() % 3 == 0; };
  const auto r = smooth_points(m, {}, is_fixed);
  check_smoothing(before, m, r);
  unsigned moved = 0;
  for (const auto v : verts(m)) {
    if (is_fixed(v)) CHECK(point(m, v) == point(before, v));
    else moved += !(point(m, v) == point(before, v));
  }
  CHECK(moved > 5);
}

TEST_CASE_TEMPLATE("smooth_points: any kind, with reflex corners, has valid results", M, CONCINO_KINDS) {
  for (const double noise : {0.0, 0.2, 0.7}) {
    const auto before = noisy_grid<M>(4, noise);
    auto m = before;
    const auto r = smooth_points(m);
    check_smoothing(before, m, r);
  }
}

TEST_CASE_TEMPLATE("smooth_points: the same result at any power of two", M, trimesh, hexmesh) {
  const auto before = noisy_grid<M>(4, 0.4);
  auto m = before;
  smooth_points(m);
  for (const double scale : {0x1p-400, 0x1p400}) {
    auto other = before;
    for (const auto v : verts(other)) set_point(other, v, scale * point(other, v));
    smooth_points(other);
    for (const auto v : verts(m)) CHECK(distance(point(other, v) / scale, point(m, v)) < 1e-9);
  }
}

TEST_CASE("smooth_points: surfaces in which the winding contradicts itself, non-manifold ones, flat and empty meshes") {
  auto m = noisy_grid<quadmesh>(6, 0.3);
  flip_winding(m, poly_id{14});
  const auto before = m;
  check_smoothing(before, m, smooth_points(m));
  for (const auto v : adj_p2v(m, poly_id{14})) CHECK(point(m, v) == point(before, v));
  trimesh empty;
  CHECK(smooth_points(empty).num_moves == 0);
  trimesh flat({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}, {0, 0, 0}}, {{0, 1, 2}, {0, 2, 3}, {4, 0, 1}});
  CHECK(smooth_points(flat).num_moves == 0);
  tetmesh point_only({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2, 3}});
  CHECK(smooth_points(point_only).num_inverted_before == 1);
}

TEST_CASE("smooth_points: errors and cancellation leave the mesh as it was") {
  constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  auto m = noisy_grid<hexmesh>(4, 0.3);
  const auto before = whole(m);
  for (const double angle : {-1.0, nan}) CHECK_THROWS_AS(smooth_points(m, {.feature_angle_deg = angle}), invalid_argument);
  unsigned calls = 0;
  const auto count = [&](double, const char* label) {
    CHECK(std::string(label) == "smoothing points");
    return ++calls < 3;
  };
  CHECK_THROWS_AS(smooth_points(m, {.progress = count}), cancelled);
  CHECK(whole(m) == before);
  for (const double x : {nan, infinity}) {
    set_point(m, vert_id{13}, vec3{x, 0, 0});
    CHECK_THROWS_WITH_AS(smooth_points(m), doctest::Contains("vert 13"), invalid_mesh);
  }
}

TEST_CASE("smooth_points: real meshes") {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  unsigned better = 0;
  for (const corpus_row& row : rows) {
    CAPTURE(row.name);
    std::visit(
        [&](auto m) {
          if (num_polys(m) > 6000 && !long_run()) return;
          const auto before = m;
          const auto r = smooth_points(m, {.max_rounds = 10});
          CHECK(r.min_shape_after >= r.min_shape_before);
          better += r.min_shape_after > 1.02 * r.min_shape_before;
        },
        load_any(row.file.string()));
  }
  CHECK(better >= std::min<std::size_t>(10, rows.size() / 6));
}
