#include <concino/generate/icosphere.hpp>

#include <support/generated.hpp>

#include <doctest/doctest.h>

#include <cmath>

using namespace concino;
using namespace concino::testing;

TEST_CASE("icosphere: has the expected counts, radius and edge lengths") {
  std::size_t quarters = 1;
  double previous = 0;
  for (unsigned s = 0; s < 4; ++s, quarters *= 4) {
    const trimesh m = icosphere(s, 2, {1, 2, 3});
    check_sound(m, 2);
    CHECK(num_polys(m) == 20 * quarters);
    CHECK(num_verts(m) == 10 * quarters + 2);
    double least = 100, most = 0, inside = 0;
    for (const poly_id p : polys(m)) {
      least = std::min(least, area(m, p));
      most = std::max(most, area(m, p));
      const polygon_shape shape = shape_of(m, adj_p2v(m, p));
      inside += dot(shape.mean - vec3{1, 2, 3}, shape.area) / 3;
    }
    CHECK(most < 1.4 * least);
    CHECK(inside > 0);
    for (const vert_id v : verts(m)) CHECK(distance(point(m, v), {1, 2, 3}) == doctest::Approx(2).epsilon(1e-14));
    const double missing = 1 - total_measure(m) / (16 * 3.14159265358979323846);
    if (s > 1) CHECK(missing == doctest::Approx(previous / 4).epsilon(0.05));
    previous = missing;
  }
  // The square of an edge of the icosahedron is 16 / (10 + 2 sqrt 5).
  CHECK(total_measure(icosphere(0)) == doctest::Approx(20 * std::sqrt(3.0) / (5 + std::sqrt(5.0)) * 2).epsilon(1e-13));
  const trimesh m = icosphere(2), large = icosphere(2, 0x1p20);
  for (const vert_id v : verts(m)) CHECK(point(large, v) == 0x1p20 * point(m, v));
}

TEST_CASE("icosphere: throws if an argument is out of range") {
  CHECK_THROWS_WITH_AS(icosphere(13), "icosphere: subdivisions is 13; it must be at most 12", invalid_argument);
  CHECK_THROWS_WITH_AS(icosphere(1, 0), "icosphere: radius is 0; it must be finite and above 0", invalid_argument);
  CHECK_THROWS_WITH_AS(icosphere(1, 1, {0, std::nan(""), 0}), "icosphere: centre.y is not finite", invalid_argument);
}
