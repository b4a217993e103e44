#include <concino/geometry/hausdorff_distance.hpp>

#include <concino/generate/icosphere.hpp>
#include <concino/geometry/bounding_tree.hpp>
#include <concino/io/load.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/quadmesh.hpp>
#include <concino/mesh/trimesh.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M>
M moved(M m, const vec3& by, double factor = 1) {
  for (const auto v : verts(m)) set_point(m, v, factor * (point(m, v) + by));
  return m;
}

/// The largest distance from `to` at the points of a fine grid on each triangle of `from`.
template<class A, class B>
double sampled_distance(const A& from, const B& to, unsigned n) {
  const auto tree = bounding_tree(to);
  double most = 0;
  for (const auto& t : concino::detail::all_triangles(from))
    for (unsigned i = 0; i <= n; ++i)
      for (unsigned j = 0; i + j <= n; ++j) most = std::max(most, tree.closest((i * t[0] + j * t[1] + (n - i - j) * t[2]) / n).distance);
  return most;
}

void check_contains(const distance_bounds& d, double expected, double tolerance = 0.01) {
  CHECK(d.lower <= expected * (1 + 1e-12) + 1e-13);
  CHECK(d.upper >= expected * (1 - 1e-12));
  CHECK(d.upper - d.lower <= tolerance * d.upper + 1e-13);
}

}  // namespace

TEST_CASE_TEMPLATE("hausdorff_distance: of parallel surfaces is their distance, in each direction", M, CONCINO_SURFACE_KINDS) {
  const M m = grid<M>(4);
  check_contains(hausdorff_distance(m, m), 0);
  check_contains(hausdorff_distance(m, moved(m, {0, 0, 0.25})), 0.25);
  const auto other = grid<trimesh>(7);
  check_contains(hausdorff_distance(m, moved(other, {0, 0, 0.25})), 0.25);
  check_contains(one_sided_distance(moved(other, {0, 0, -2}), m), 2);
}

TEST_CASE("one_sided_distance: a part is at distance 0 from the whole, not the other way round") {
  const auto whole = grid<trimesh>(4);
  auto part = whole;
  for (unsigned k = 8; k < 32; ++k) remove_poly(part, poly_id{k});
  check_contains(one_sided_distance(part, whole), 0);
  CHECK(one_sided_distance(whole, part).lower > 0.5);
  CHECK(hausdorff_distance(part, whole).lower == one_sided_distance(whole, part).lower);
}

TEST_CASE("hausdorff_distance: is largest within a triangle, where no vert shows it") {
  // two triangles on the same corners but for one, with a crease between them
  const trimesh flat({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}}, {{0, 1, 3}, {0, 3, 2}});
  const trimesh creased({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {1, 1, 0.5}}, {{0, 1, 4}, {1, 3, 4}, {3, 2, 4}, {2, 0, 4}});
  check_contains(hausdorff_distance(flat, creased), 0.5);
  const double inside = one_sided_distance(flat, creased).upper;  // the middle of the square is nearest to the sides of the pyramid
  CHECK(inside < 0.5);
  CHECK(inside == doctest::Approx(0.5 / std::sqrt(1.25)).epsilon(0.011));
}

TEST_CASE("hausdorff_distance: of spheres of triangles, against points on a fine grid") {
  const auto coarse = icosphere(1), fine = icosphere(3);
  for (const auto& [from, to] : {std::pair{&coarse, &fine}, {&fine, &coarse}}) {
    const auto d = one_sided_distance(*from, *to, {.tolerance = 1e-3});
    const double sampled = sampled_distance(*from, *to, 24);
    CHECK(d.upper >= sampled * (1 - 1e-12));
    CHECK(d.upper - d.lower <= 1e-3 * d.upper);
    CHECK(d.lower <= 1.02 * sampled);
  }
  CHECK(hausdorff_distance(coarse, fine).upper == hausdorff_distance(fine, coarse).upper);
}

TEST_CASE("hausdorff_distance: scales exactly with the mesh") {
  const auto coarse = icosphere(1), fine = icosphere(2);
  const auto d = hausdorff_distance(coarse, fine);
  for (const double factor : {0x1p-900, 0x1p300, 0x1p900}) {
    const auto scaled = hausdorff_distance(moved(coarse, {}, factor), moved(fine, {}, factor));
    CHECK(scaled.lower == factor * d.lower);
    CHECK(scaled.upper == factor * d.upper);
  }
}

TEST_CASE("hausdorff_distance: of surfaces without polys") {
  const trimesh none, one = icosphere(0);
  const double infinite = std::numeric_limits<double>::infinity();
  CHECK(hausdorff_distance(none, none).upper == 0);
  CHECK(one_sided_distance(none, one).upper == 0);
  CHECK(one_sided_distance(one, none).lower == infinite);
  CHECK(hausdorff_distance(none, one).lower == infinite);
}

TEST_CASE("hausdorff_distance: of triangles without area") {
  const trimesh needle({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
  const trimesh spot({{0, 1, 0}, {0, 1, 0}, {0, 1, 0}}, {{0, 1, 2}});
  check_contains(one_sided_distance(needle, spot), std::sqrt(5.0));
  check_contains(one_sided_distance(spot, needle), 1);
}

TEST_CASE("hausdorff_distance: keeps its bounds where it must stop early") {
  const auto m = grid<trimesh>(4);
  const auto other = moved(grid<trimesh>(7), {0, 0, 1e-4});
  const auto d = hausdorff_distance(m, other, {.max_cuts = 1});
  CHECK(d.lower <= 1e-4 * (1 + 1e-9));
  CHECK(d.upper >= 1e-4 * (1 - 1e-9));
  CHECK(d.upper < 0.3);
}

TEST_CASE("hausdorff_distance: errors") {
  const auto m = grid<trimesh>(2);
  CHECK_THROWS_AS(hausdorff_distance(m, m, {.tolerance = 1}), invalid_argument);
  CHECK_THROWS_AS(hausdorff_distance(m, m, {.tolerance = -1}), invalid_argument);
  CHECK_THROWS_AS(one_sided_distance(m, m, {.max_cuts = std::nan("")}), invalid_argument);
  auto bad = m;
  set_point(bad, vert_id{1}, vec3{0, std::nan(""), 0});
  CHECK_THROWS_AS(hausdorff_distance(m, bad), invalid_mesh);
  CHECK_THROWS_AS(hausdorff_distance(bad, m), invalid_mesh);
}

TEST_CASE("hausdorff_distance: of a real mesh and itself, moved a little") {
  CONCINO_CORPUS_OR_SKIP(file, "tri/torus.obj");
  const auto m = load<trimesh>(file.string());
  const double by = 1e-3;
  const auto d = hausdorff_distance(m, moved(m, {by, 0, 0}));
  CHECK(d.upper <= by * (1 + 1e-9));
  CHECK(d.upper > by / 2);
}
