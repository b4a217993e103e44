#include <concino/generate/jitter.hpp>

#include <concino/generate/grid.hpp>
#include <concino/geometry/bounding_box.hpp>

#include <support/generated.hpp>
#include <support/kinds.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace concino;
using namespace concino::testing;

namespace concino {

/// A user's surface whose points can be moved.
struct movable : user_mesh::surface {};
template<>
struct mesh_traits<movable> : mesh_traits<user_mesh::surface> {
  template<class P> static void set_point(movable& m, vert v, const P& x) { m.points[static_cast<std::size_t>(v.i)] = {x[0], x[1], x[2]}; }
};

}  // namespace concino

TEST_CASE_TEMPLATE("jitter: moves the interior by at most the amount, and cells stay valid", M, CONCINO_KINDS) {
  const M before = make_grid<M>({.cells = {5, 4, 3}});
  M m = before;
  jitter(m, 0.15);
  check_sound(m, 1);
  CHECK(total_measure(m) == doctest::Approx(1).epsilon(1e-13));
  std::size_t moved = 0;
  for (const vert_t<M> v : verts(m)) {
    const vec3 x = point(before, v), d = vec3(point(m, v)) - x;
    bool inside = true;
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension_v<M>); ++k) inside = inside && x[k] > 0 && x[k] < 1;
    if (SurfaceMesh<M>) CHECK(d.z == 0);
    CHECK((d == vec3{}) == !inside);
    double shortest = 10;
    for (const vert_t<M> w : adj_v2v(before, v)) shortest = std::min(shortest, distance(x, point(before, w)));
    CHECK(std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) <= 0.15 * shortest * (1 + 1e-12));
    moved += inside;
  }
  CHECK(moved > 0);
}

TEST_CASE_TEMPLATE("jitter: depends only on the seed, at any scale", M, CONCINO_KINDS) {
  M a = make_grid<M>({.cells = {3, 3, 3}}), b = a, c = a, large = make_grid<M>({.cells = {3, 3, 3}, .max = {0x1p20, 0x1p20, 0x1p20}});
  jitter(a, 0.2, {.seed = 7});
  jitter(b, 0.2, {.seed = 7});
  jitter(c, 0.2, {.seed = 8});
  jitter(large, 0.2, {.seed = 7});
  bool differs = false;
  for (const vert_t<M> v : verts(a)) {
    CHECK(point(a, v) == point(b, v));
    CHECK(point(large, v) == 0x1p20 * point(a, v));
    differs = differs || point(a, v) != point(c, v);
  }
  CHECK(differs);
  M free = make_grid<M>({.cells = {3, 3, 3}});
  jitter(free, 0.2, {.keep_boundary = false, .in_plane = false});
  CHECK(bounding_box(free).max.z != bounding_box(a).max.z);
}

TEST_CASE("jitter: the random numbers are the same on every machine") {
  auto m = make_grid<quadmesh>({.cells = {2, 2}, .max = {2, 2, 0}});
  jitter(m, 0.25);
  concino::detail::random_stream random(1);
  for (int i = 0; i < 4 * 3; ++i) random.next();  // each vert uses three numbers, and the fifth vert is interior
  const double dx = 2 * random.unit() - 1, dy = 2 * random.unit() - 1;
  CHECK(point(m, vert_id{4}).x == doctest::Approx(1 + 0.25 * dx).epsilon(1e-15));
  CHECK(point(m, vert_id{4}).y == doctest::Approx(1 + 0.25 * dy).epsilon(1e-15));
}

TEST_CASE("jitter: planar surfaces stay in their plane, isolated verts do not move") {
  auto m = make_grid<polygonmesh>({.cells = {5, 5}});
  const vec3 u = vec3{1, 2, 2} / 3, w = vec3{2, 1, -2} / 3, n = cross(u, w);
  for (const vert_id v : verts(m)) set_point(m, v, point(m, v).x * u + point(m, v).y * w + 5 * n);
  jitter(m, 0.3, {.keep_boundary = false});
  for (const vert_id v : verts(m)) CHECK(dot(point(m, v), n) == doctest::Approx(5).epsilon(1e-14));

  movable s{user_mesh::surface_example()};
  const auto points = s.points;
  jitter(s, 0.1, {.keep_boundary = false});
  for (std::size_t i = 0; i < points.size(); ++i) CHECK((s.points[i] == points[i]) == (i == 7));
  CHECK(s.points[3][2] == 0);
}

TEST_CASE_TEMPLATE("jitter: errors leave the mesh unchanged; degenerate and empty meshes are accepted", M, CONCINO_KINDS) {
  M m = make_grid<M>({.cells = {2, 2, 2}});
  CHECK_THROWS_WITH_AS(jitter(m, -1), "jitter: amount is -1; it must be finite and 0 or more", invalid_argument);
  CHECK_THROWS_AS(jitter(m, std::nan("")), invalid_argument);
  CHECK_THROWS_AS(jitter(m, std::numeric_limits<double>::infinity()), invalid_argument);
  auto bad = m;
  set_point(bad, vert_t<M>{1}, vec3{0, std::nan(""), 0});
  CHECK_THROWS_WITH_AS(jitter(bad, 0.1), "jitter: the point of vert 1 is not finite; nothing was moved", invalid_mesh);
  for (const vert_t<M> v : verts(m)) set_point(m, v, vec3{1, 2, 3});
  jitter(m, 0.2, {.keep_boundary = false});
  for (const vert_t<M> v : verts(m)) CHECK(point(m, v) == vec3{1, 2, 3});
  M empty;
  jitter(empty, 0.2);
  CHECK(num_verts(empty) == 0);
}
