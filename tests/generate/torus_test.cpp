#include <concino/generate/torus.hpp>

#include <support/generated.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double pi = 3.14159265358979323846;

}  // namespace

TEST_CASE_TEMPLATE("make_torus: is valid, oriented outward, and converges to the torus", M, CONCINO_KINDS) {
  const vec3 centre{1, 2, 3};
  const double exact = SurfaceMesh<M> ? 4 * pi * pi * 3 * 1 : 2 * pi * pi * 3 * 1 * 1;
  double previous = 0;
  for (const std::size_t cells : {3u, 4u, 8u, 16u}) {
    const M m = make_torus<M>({.cells = {cells + 1, cells}, .radius = 3, .tube_radius = 1, .centre = centre});
    check_sound(m, 0);
    const auto is_on = [&](const vec3& x) { return std::abs(std::hypot(std::hypot(x.x - 1, x.y - 2) - 3, x.z - 3) - 1) < 1e-13; };
    if constexpr (SurfaceMesh<M>) {
      for (const vert_t<M> v : verts(m)) CHECK(is_on(point(m, v)));
      double inside = 0;
      for (const poly_t<M> p : polys(m)) {
        const polygon_shape s = shape_of(m, adj_p2v(m, p));
        inside += dot(s.mean - centre, s.area) / 3;
      }
      CHECK(inside > 0);
    } else {
      for (const face_t<M> f : faces(m)) {
        std::size_t n = 0;
        for ([[maybe_unused]] const poly_t<M> p : adj_f2p(m, f)) ++n;
        if (n == 1)
          for (const vert_t<M> v : adj_f2v(m, f)) CHECK(is_on(point(m, v)));
      }
    }
    const double missing = 1 - total_measure(m) / exact;
    CHECK(missing > 0);
    if (cells == 16) CHECK(missing < 0.3 * previous);
    previous = missing;
  }
  CHECK(previous < 0.06);
}

TEST_CASE("make_torus: has the expected numbers of elements; polygons are hexagons") {
  CHECK(num_polys(make_torus<trimesh>()) == 2 * 32 * 16);
  CHECK(num_polys(make_torus<quadmesh>()) == 32 * 16);
  const auto m = make_torus<polygonmesh>();
  CHECK(num_polys(m) == 32 * 16);
  for (const poly_id p : polys(m)) CHECK(adj_p2v(m, p).size() == 6);
  CHECK(num_polys(make_torus<hexmesh>()) == 32 * (16 + 2 * 16));
  CHECK(num_polys(make_torus<tetmesh>({.cells = {5, 9}})) == 6 * 5 * (9 + 2 * 12));
}

TEST_CASE_TEMPLATE("make_torus: scales exactly", M, CONCINO_KINDS) {
  const M m = make_torus<M>({.cells = {5, 6}}), small = make_torus<M>({.cells = {5, 6}, .radius = 0x1p-20, .tube_radius = 0.4 * 0x1p-20});
  for (const vert_t<M> v : verts(m)) CHECK(point(small, v) == 0x1p-20 * point(m, v));
}

TEST_CASE_TEMPLATE("make_torus: throws if an option is out of range", M, CONCINO_KINDS) {
  CHECK_THROWS_WITH_AS(make_torus<M>({.cells = {3, 2}}), "make_torus: cells[1] is 2; it must be at least 3", invalid_argument);
  CHECK_THROWS_AS(make_torus<M>({.cells = {1u << 20, 1u << 20}}), invalid_argument);
  CHECK_THROWS_AS(make_torus<M>({.radius = 0}), invalid_argument);
  CHECK_THROWS_AS(make_torus<M>({.tube_radius = std::nan("")}), invalid_argument);
  CHECK_THROWS_WITH_AS(make_torus<M>({.tube_radius = 1}), "make_torus: tube_radius is 1; it must be below radius, which is 1", invalid_argument);
  CHECK_THROWS_AS(make_torus<M>({.centre = {std::nan(""), 0, 0}}), invalid_argument);
}
