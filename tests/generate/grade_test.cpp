#include <concino/generate/grade.hpp>

#include <concino/generate/grid.hpp>

#include <support/generated.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("grade: applies the power and keeps the bounding box", M, CONCINO_KINDS) {
  const grid_options o{.cells = {4, 5, 3}, .min = {1, 0, -1}, .max = {3, 1, 2}};
  const M before = make_grid<M>(o);
  M m = before;
  grade(m, {2, 1, 3});
  check_sound(m, 1);
  CHECK(total_measure(m) == doctest::Approx(total_measure(before)).epsilon(1e-13));
  CHECK(bounding_box(m).min == bounding_box(before).min);
  CHECK(bounding_box(m).max == bounding_box(before).max);
  for (const vert_t<M> v : verts(m)) {
    const vec3 x = point(before, v), y = point(m, v);
    CHECK(y.x == doctest::Approx(1 + (x.x - 1) * (x.x - 1) / 2).epsilon(1e-14));
    CHECK(y.y == x.y);
    if (SurfaceMesh<M>) CHECK(y.z == x.z);
    else CHECK(y.z == doctest::Approx(-1 + 3 * std::pow((x.z + 1) / 3, 3)).epsilon(1e-14));
  }
  M large = make_grid<M>({.cells = o.cells, .min = 0x1p20 * o.min, .max = 0x1p20 * o.max});
  grade(large, {2, 1, 3});
  for (const vert_t<M> v : verts(m)) CHECK(point(large, v) == 0x1p20 * point(m, v));
}

TEST_CASE_TEMPLATE("grade: errors leave the mesh unchanged; empty meshes stay empty", M, CONCINO_KINDS) {
  M m = make_grid<M>({.cells = {2, 2, 2}});
  CHECK_THROWS_WITH_AS(grade(m, {1, 0, 1}), "grade: the power along y is 0; it must be finite and above 0", invalid_argument);
  CHECK_THROWS_AS(grade(m, {1, 1, std::nan("")}), invalid_argument);
  CHECK_THROWS_AS(grade(m, {std::numeric_limits<double>::infinity(), 1, 1}), invalid_argument);
  const vert_t<M> v{0};
  set_point(m, v, vec3{std::nan(""), 0, 0});
  CHECK_THROWS_WITH_AS(grade(m, {2, 2, 2}), "grade: the point of vert 0 is not finite; nothing was moved", invalid_mesh);
  set_point(m, v, vec3{-1e308, 0, 0});
  set_point(m, vert_t<M>{1}, vec3{1e308, 0, 0});
  CHECK_THROWS_WITH_AS(grade(m, {2, 2, 2}), "grade: the size of the mesh exceeds the largest double; nothing was moved", invalid_mesh);
  M empty;
  grade(empty, {2, 2, 2});
  CHECK(num_verts(empty) == 0);
}
