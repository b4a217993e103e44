#include <concino/generate/cylinder.hpp>

#include <support/generated.hpp>
#include <support/kinds.hpp>
#include <support/subdivisions.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("make_cylinder: is valid, oriented outward, of the known measure", M, CONCINO_KINDS) {
  for (const std::size_t cells : {1u, 4u, 5u, 8u, 12u}) {
    const M m = make_cylinder<M>({.cells = {cells, cells == 1 ? 1u : 3u}, .radius = 2, .height = 5, .centre = {1, 2, 3}});
    check_sound(m, dimension_v<M> == 2 ? 2 : 1);
    const double around = 4 * std::ceil(static_cast<double>(cells) / 4), angle = 2 * 3.14159265358979323846 / around, base = around * 2 * std::sin(angle);
    if constexpr (SurfaceMesh<M>) {
      CHECK(total_measure(m) == doctest::Approx(2 * base + around * 4 * std::sin(angle / 2) * 5).epsilon(1e-12));
      CHECK(enclosed_volume(m) == doctest::Approx(5 * base).epsilon(1e-12));
    } else {
      CHECK(total_measure(m) == doctest::Approx(5 * base).epsilon(1e-12));
    }
    for (const vert_t<M> v : verts(m)) {
      const vec3 x = to_vec3(point(m, v)) - vec3{1, 2, 3};
      CHECK(x.z >= 0);
      CHECK(x.z <= 5);
      CHECK(std::hypot(x.x, x.y) < 2 * (1 + 1e-14));
      if (SurfaceMesh<M> && x.z > 0 && x.z < 5) CHECK(std::hypot(x.x, x.y) == doctest::Approx(2).epsilon(1e-14));
    }
  }
}

TEST_CASE("make_cylinder: has the expected numbers of elements") {
  const std::size_t disk = 64 + 4 * 32;
  CHECK(num_polys(make_cylinder<quadmesh>()) == 2 * disk + 8 * 32);
  CHECK(num_polys(make_cylinder<trimesh>()) == 2 * (2 * disk + 8 * 32));
  CHECK(num_polys(make_cylinder<hexmesh>()) == 8 * disk);
  CHECK(num_polys(make_cylinder<tetmesh>({.cells = {4, 2}})) == 6 * 2 * 5);
}

TEST_CASE_TEMPLATE("make_cylinder: throws if an option is out of range", M, quadmesh, hexmesh) {
  CHECK_THROWS_WITH_AS(make_cylinder<M>({.cells = {0, 2}}), "make_cylinder: cells[0] is 0; it must be at least 1", invalid_argument);
  CHECK_THROWS_WITH_AS(make_cylinder<M>({.cells = {4, 0}}), "make_cylinder: cells[1] is 0; it must be at least 1", invalid_argument);
  CHECK_THROWS_WITH_AS(make_cylinder<M>({.cells = {1u << 20, ~std::size_t{0}}}), doctest::Contains("make_cylinder: cells asks for"), invalid_argument);
  CHECK_THROWS_WITH_AS(make_cylinder<M>({.radius = 0}), "make_cylinder: radius is 0; it must be finite and above 0", invalid_argument);
  CHECK_THROWS_WITH_AS(make_cylinder<M>({.height = -1}), "make_cylinder: height is -1; it must be finite and above 0", invalid_argument);
  CHECK_THROWS_WITH_AS(make_cylinder<M>({.centre = {0, std::numeric_limits<double>::infinity(), 0}}), "make_cylinder: centre.y is not finite", invalid_argument);
}
