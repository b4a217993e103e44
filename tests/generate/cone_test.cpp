#include <concino/generate/cone.hpp>

#include <concino/quality/poly_quality.hpp>

#include <support/generated.hpp>
#include <support/kinds.hpp>
#include <support/subdivisions.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("make_cone: is valid, oriented outward, and converges to the cone", M, CONCINO_KINDS) {
  constexpr double pi = 3.14159265358979323846;
  const double exact = SurfaceMesh<M> ? pi * 3 * (3 + 5) : pi * 9 * 4 / 3;
  double previous = 0;
  for (const std::size_t cells : {1u, 2u, 4u, 7u}) {
    const M m = make_cone<M>({.cells = cells, .radius = 3, .height = 4, .centre = {1, 2, 3}});
    check_sound(m, dimension_v<M> == 2 ? 2 : 1);
    bool has_apex = false;
    for (const vert_t<M> v : verts(m)) {
      const vec3 x = to_vec3(point(m, v)) - vec3{1, 2, 3};
      const double scale = std::hypot(x.x, x.y) / 3 + x.z / 4;
      CHECK(scale < 1 + 1e-14);
      CHECK(x.z >= 0);
      if (SurfaceMesh<M>) CHECK((x.z == 0 || scale > 1 - 1e-14));
      has_apex = has_apex || distance(x, {0, 0, 4}) < 1e-14;
    }
    CHECK(has_apex);
    if constexpr (SurfaceMesh<M>) CHECK(enclosed_volume(m) > 0);
    if constexpr (arity_v<M> == 8)
      for (const poly_t<M> p : polys(m)) CHECK(quality(m, p, metric::scaled_jacobian) > 0.05);
    const double missing = 1 - total_measure(m) / exact;
    CHECK(missing > 0);
    if (cells > 2) CHECK(missing < 0.35 * previous);
    previous = missing;
  }
  CHECK(previous < 0.02);
}

TEST_CASE_TEMPLATE("make_cone: truncated cones, which may widen, converge too", M, quadmesh, tetmesh) {
  constexpr double pi = 3.14159265358979323846;
  for (const double top : {1.0, 6.0}) {
    const double slant = std::hypot(3 - top, 4), exact = SurfaceMesh<M> ? pi * (9 + top * top + (3 + top) * slant) : pi * 4 / 3 * (9 + 3 * top + top * top);
    double previous = 0;
    for (const std::size_t cells : {1u, 3u, 7u}) {
      const M m = make_cone<M>({.cells = cells, .radius = 3, .top_radius = top, .height = 4, .centre = {1, 2, 3}});
      check_sound(m, dimension_v<M> == 2 ? 2 : 1);
      double widest = 0;
      bool is_inside = true, is_on_boundary = true;
      for (const vert_t<M> v : verts(m)) {
        const vec3 x = to_vec3(point(m, v)) - vec3{1, 2, 3};
        const double r = 3 + (top - 3) * x.z / 4, across = std::hypot(x.x, x.y);
        is_inside &= across < r + 1e-13;
        is_on_boundary &= x.z == 0 || x.z == 4 || across > r - 1e-13;
        if (x.z == 4) widest = std::max(widest, across);
      }
      CHECK(is_inside);
      CHECK(is_on_boundary == SurfaceMesh<M>);
      CHECK(widest == doctest::Approx(top).epsilon(1e-14));
      if constexpr (SurfaceMesh<M>) CHECK(enclosed_volume(m) > 0);
      const double missing = 1 - total_measure(m) / exact;
      CHECK(missing > 0);
      if (previous > 0) CHECK(missing < 0.4 * previous);
      previous = missing;
    }
    CHECK(previous < 0.03);
  }
}

TEST_CASE("make_cone: has the expected numbers of elements") {
  CHECK(num_polys(make_cone<quadmesh>({.cells = 3})) == 3 * 16 + 16 + 2 * 16);
  CHECK(num_polys(make_cone<trimesh>({.cells = 4})) == 2 * (3 * 16 + 16 + 2 * 16));
  CHECK(num_polys(make_cone<hexmesh>({.cells = 4})) == 32 + 2 * 48);
  CHECK(num_polys(make_cone<quadmesh>({.cells = 4, .top_radius = 2})) == 2 * (16 + 2 * 16) + 4 * 16);
}

TEST_CASE_TEMPLATE("make_cone: throws if an option is out of range", M, quadmesh, hexmesh) {
  CHECK_THROWS_WITH_AS(make_cone<M>({.cells = 0}), "make_cone: cells is 0; it must be at least 1", invalid_argument);
  CHECK_THROWS_WITH_AS(make_cone<M>({.cells = ~std::size_t{0}}), doctest::Contains("make_cone: cells asks for"), invalid_argument);
  CHECK_THROWS_WITH_AS(make_cone<M>({.radius = std::nan("")}), "make_cone: radius is nan; it must be finite and above 0", invalid_argument);
  CHECK_THROWS_WITH_AS(make_cone<M>({.top_radius = -1}), "make_cone: top_radius is -1; it must be finite and not below 0", invalid_argument);
  CHECK_THROWS_WITH_AS(make_cone<M>({.top_radius = std::nan("")}), doctest::Contains("make_cone: top_radius is nan"), invalid_argument);
  CHECK_THROWS_WITH_AS(make_cone<M>({.cells = ~std::size_t{0}, .top_radius = 1}), doctest::Contains("make_cone: cells asks for"), invalid_argument);
  CHECK_THROWS_WITH_AS(make_cone<M>({.height = 0}), "make_cone: height is 0; it must be finite and above 0", invalid_argument);
  CHECK_THROWS_WITH_AS(make_cone<M>({.centre = {0, 0, std::numeric_limits<double>::infinity()}}), "make_cone: centre.z is not finite", invalid_argument);
}
