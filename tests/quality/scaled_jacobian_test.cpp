// scaled_jacobian: regular simplices, known values of right-angled ones, degenerate and inverted ones, all scales.
#include <concino/quality/scaled_jacobian.hpp>

#include <doctest/doctest.h>

#include <cmath>

namespace cn = concino;

TEST_CASE("scaled_jacobian: triangles") {
  const double h = std::sqrt(3.0) / 2;
  CHECK(cn::scaled_jacobian({0, 0, 0}, {1, 0, 0}, {0.5, h, 0}) == doctest::Approx(1));
  CHECK(cn::scaled_jacobian({0, 0, 0}, {1, 0, 0}, {0, 0, 1}) == doctest::Approx(std::sqrt(0.5) / h));  // the sine of 45 degrees
  CHECK(cn::scaled_jacobian({0, 0, 0}, {1, 0, 0}, {3, 0, 0}) == 0);
  CHECK(cn::scaled_jacobian({1, 1, 1}, {1, 1, 1}, {2, 1, 1}) == 0);
  for (const double s : {1e-200, 1e-3, 1e150}) CHECK(cn::scaled_jacobian({0, 0, 0}, {s, 0, 0}, {0, 0, s}) == doctest::Approx(std::sqrt(0.5) / h));
}

TEST_CASE("scaled_jacobian: tets") {
  const cn::vec3 a{1, 1, 1}, b{1, -1, -1}, c{-1, 1, -1}, d{-1, -1, 1};
  CHECK(std::abs(cn::scaled_jacobian(a, b, c, d)) == doctest::Approx(1));
  CHECK(cn::scaled_jacobian(a, b, d, c) == doctest::Approx(-cn::scaled_jacobian(a, b, c, d)));
  // the largest product of three lengths is sqrt(2) sqrt(2) 1, at the corners without right angle
  const double corner = std::sqrt(2.0) / 2;
  CHECK(cn::scaled_jacobian({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}) == doctest::Approx(corner));
  CHECK(cn::scaled_jacobian({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}) < 0);
  CHECK(cn::scaled_jacobian({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}) == 0);
  CHECK(cn::scaled_jacobian({}, {}, {}, {}) == 0);
  for (const double s : {1e-200, 1e-3, 1e150}) CHECK(cn::scaled_jacobian({0, 0, 0}, {s, 0, 0}, {0, s, 0}, {0, 0, s}) == doctest::Approx(corner));
}
