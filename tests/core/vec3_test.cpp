#include <concino/core/vec3.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>

using namespace concino;

TEST_CASE("vec3: arithmetic is componentwise") {
  const vec3 a{1, 2.5, -3}, b{4, 0, 2};
  CHECK(a + b == vec3{5, 2.5, -1});
  CHECK(a - b == vec3{-3, 2.5, -5});
  CHECK(2 * a == a * 2);
  CHECK(a / 2 == vec3{0.5, 1.25, -1.5});
  CHECK(-a == vec3{-1, -2.5, 3});
  CHECK(dot(a, b) == -2);
  CHECK(cross(vec3{1, 0, 0}, vec3{0, 1, 0}) == vec3{0, 0, 1});
  CHECK(cross(a, b) == -cross(b, a));
  CHECK((a[0] == 1 && a[1] == 2.5 && a[2] == -3));
}

TEST_CASE("vec3: length and distance are right at every scale of doubles") {
  for (const double scale : {1e-320, 1e-200, 1e-150, 1e-140, 1e-20, 1.0, 1e20, 1e140, 1e150, 1e200, 1e300}) {
    CHECK(norm(vec3{2 * scale, 3 * scale, 6 * scale}) == doctest::Approx(7 * scale).epsilon(scale < 1e-310 ? 1e-2 : 1e-15));
    CHECK(distance(vec3{scale, 0, 0}, vec3{0, 0, 0}) == doctest::Approx(scale).epsilon(1e-15));
  }
  CHECK(norm(vec3{}) == 0);
  CHECK(norm(vec3{-3, 4, 0}) == 5);
  CHECK(norm(vec3{std::numeric_limits<double>::infinity(), 0, 0}) == std::numeric_limits<double>::infinity());
  CHECK(std::isnan(norm(vec3{std::nan(""), 0, 1})));
  CHECK(norm(0x1p300 * vec3{0.1, 0.2, 0.3}) == doctest::Approx(0x1p300 * norm(vec3{0.1, 0.2, 0.3})).epsilon(1e-15));
}

TEST_CASE("vec3: converts from any point type, finite or not") {
  CHECK(to_vec3(std::array<float, 3>{1, 2, 3}) == vec3{1, 2, 3});
  const int raw[3] = {4, 5, 6};
  CHECK(to_vec3(raw) == vec3{4, 5, 6});
  CHECK(is_finite(vec3{1, 2, 3}));
  CHECK_FALSE(is_finite(vec3{1, std::nan(""), 3}));
  CHECK_FALSE(is_finite(vec3{1, 2, -std::numeric_limits<double>::infinity()}));
}
