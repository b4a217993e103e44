#include <concino/generate/sphere.hpp>

#include <support/generated.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double pi = 3.14159265358979323846;

}  // namespace

TEST_CASE_TEMPLATE("make_sphere: is valid, oriented outward, and converges to the sphere", M, CONCINO_KINDS) {
  const double exact = SurfaceMesh<M> ? 4 * pi * 4 : 4 * pi * 8 / 3;
  double previous = 0;
  for (const std::size_t cells : {1u, 2u, 3u, 6u}) {
    const M m = make_sphere<M>({.cells = cells, .radius = 2, .centre = {1, 2, 3}});
    check_sound(m, SurfaceMesh<M> ? 2 : 1);
    CHECK(validate(m).facts.closed);
    if constexpr (SurfaceMesh<M>) {
      for (const vert_t<M> v : verts(m)) CHECK(distance(point(m, v), {1, 2, 3}) == doctest::Approx(2).epsilon(1e-14));
      for (const poly_t<M> p : polys(m)) {
        const polygon_shape s = shape_of(m, adj_p2v(m, p));
        CHECK(dot(s.mean - vec3{1, 2, 3}, s.area) > 0);
      }
    } else {
      for (const face_t<M> f : faces(m)) {
        std::size_t n = 0;
        for ([[maybe_unused]] const poly_t<M> p : adj_f2p(m, f)) ++n;
        if (n == 1)
          for (const vert_t<M> v : adj_f2v(m, f)) CHECK(distance(point(m, v), {1, 2, 3}) == doctest::Approx(2).epsilon(1e-14));
      }
    }
    const double missing = 1 - total_measure(m) / exact;
    CHECK(missing > 0);
    if (cells == 6) CHECK(missing < 0.3 * previous);  // second order: a quarter of the error
    previous = missing;
  }
  CHECK(previous < 0.03);
}

TEST_CASE("make_sphere: has the expected numbers of elements") {
  CHECK(num_polys(make_sphere<trimesh>({.cells = 5})) == 300);
  CHECK(num_polys(make_sphere<quadmesh>({.cells = 5})) == 150);
  CHECK(num_verts(make_sphere<quadmesh>({.cells = 5})) == 152);
  CHECK(num_polys(make_sphere<polygonmesh>({.cells = 5})) == 152);
  CHECK(num_verts(make_sphere<polygonmesh>({.cells = 5})) == 300);
  CHECK(num_polys(make_sphere<hexmesh>({.cells = 3})) == 27 + 2 * 54);
  CHECK(num_polys(make_sphere<tetmesh>({.cells = 3})) == 6 * (27 + 2 * 54));
}

TEST_CASE_TEMPLATE("make_sphere: scales exactly and has the symmetries of a cube", M, quadmesh, polygonmesh, hexmesh) {
  const M m = make_sphere<M>({.cells = 4}), large = make_sphere<M>({.cells = 4, .radius = 0x1p20});
  vec3 sum;
  for (const vert_t<M> v : verts(m)) {
    CHECK(point(large, v) == 0x1p20 * point(m, v));
    sum += point(m, v);
  }
  if (!std::is_same_v<M, polygonmesh>) CHECK(norm(sum) < 1e-13);
}

TEST_CASE_TEMPLATE("make_sphere: throws if an option is out of range", M, CONCINO_KINDS) {
  CHECK_THROWS_WITH_AS(make_sphere<M>({.cells = 0}), "make_sphere: cells is 0; it must be at least 1", invalid_argument);
  CHECK_THROWS_WITH_AS(make_sphere<M>({.cells = 100000}), doctest::Contains("make_sphere: cells asks for"), invalid_argument);
  CHECK_THROWS_AS(make_sphere<M>({.cells = ~std::size_t{0}}), invalid_argument);
  CHECK_THROWS_WITH_AS(make_sphere<M>({.radius = -1}), "make_sphere: radius is -1; it must be finite and above 0", invalid_argument);
  CHECK_THROWS_AS(make_sphere<M>({.radius = std::nan("")}), invalid_argument);
  CHECK_THROWS_AS(make_sphere<M>({.radius = std::numeric_limits<double>::infinity()}), invalid_argument);
  CHECK_THROWS_WITH_AS(make_sphere<M>({.centre = {0, 0, std::nan("")}}), "make_sphere: centre.z is not finite", invalid_argument);
}
