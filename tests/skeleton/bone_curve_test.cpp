#include <concino/skeleton/bone_curve.hpp>

#include <concino/core/error.hpp>

#include <doctest/doctest.h>

#include <limits>

using namespace concino;

TEST_CASE("length and sample: along a curve of unequal segments") {
  const bone_curve c{{{0, 0, 0}, {3, 0, 0}, {3, 1, 0}}, {1, 4, 2}};
  CHECK(length(c) == 4);
  const auto at = [&](double t) { return sample(c, t); };
  CHECK(at(0).point == c.points[0]);
  CHECK(at(1).point == c.points[2]);
  CHECK(at(0).radius == 1);
  CHECK(at(1).radius == 2);
  CHECK(at(0.25).point == vec3{1, 0, 0});
  CHECK(at(0.25).radius == doctest::Approx(2));
  CHECK(at(0.25).direction == vec3{1, 0, 0});
  CHECK(at(0.75).point == vec3{3, 0, 0});
  CHECK(at(0.875).point == vec3{3, 0.5, 0});
  CHECK(at(0.875).radius == 3);
  CHECK(at(0.875).direction == vec3{0, 1, 0});
  CHECK(at(0.875).segment == 1);
  CHECK(at(0.875).parameter == 0.5);
  bone_curve large = c;
  for (vec3& x : large.points) x *= 0x1p700;
  CHECK(length(large) == 0x1p702);
  CHECK(sample(large, 0.3).point == 0x1p700 * at(0.3).point);
}

TEST_CASE("length and sample: curves without length, without radii, and with equal points") {
  CHECK(length({}) == 0);
  const bone_curve one{{{1, 2, 3}}, {}}, equal{{{1, 1, 1}, {1, 1, 1}}, {3, 4}};
  CHECK(sample(one, 0.5).point == vec3{1, 2, 3});
  CHECK(sample(equal, 1).point == vec3{1, 1, 1});
  CHECK(sample(equal, 1).direction == vec3{});
  const bone_curve repeated{{{0, 0, 0}, {0, 0, 0}, {2, 0, 0}, {2, 0, 0}}, {}};
  CHECK(sample(repeated, 0).direction == vec3{1, 0, 0});
  CHECK(sample(repeated, 1).point == vec3{2, 0, 0});
  CHECK(sample(repeated, 0.5).point == vec3{1, 0, 0});
  CHECK(sample(repeated, 0.5).radius == 0);
}

TEST_CASE("sample: refuses fractions out of range, and curves that are not right") {
  const bone_curve c{{{0, 0, 0}, {3, 0, 0}}, {}};
  for (const double t : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()})
    CHECK_THROWS_WITH_AS((void)sample(c, t), "sample: the fraction has to be from 0 to 1, as a part of the length", invalid_argument);
  CHECK_THROWS_WITH_AS((void)sample({}, 0), "sample: the curve has no points", invalid_argument);
  CHECK_THROWS_WITH_AS((void)sample({{{0, 0, 0}, {3, 0, 0}}, {1}}, 0), "sample: 1 radii for 2 points", invalid_argument);
}
