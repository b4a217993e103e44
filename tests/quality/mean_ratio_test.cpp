// mean_ratio: regular simplices, known values of right-angled ones, degenerate and inverted ones, all scales.
#include <concino/quality/mean_ratio.hpp>

#include <doctest/doctest.h>

#include <cmath>

namespace cn = concino;

TEST_CASE("mean_ratio: triangles") {
  const double h = std::sqrt(3.0) / 2;
  CHECK(cn::mean_ratio({0, 0, 0}, {1, 0, 0}, {0.5, h, 0}) == doctest::Approx(1));
  CHECK(cn::mean_ratio({0, 0, 0}, {0.5, h, 0}, {1, 0, 0}) == doctest::Approx(1));
  CHECK(cn::mean_ratio({0, 0, 0}, {1, 0, 0}, {0, 0, 1}) == doctest::Approx(h));  // 2 sqrt(3) / (1 + 1 + 2)
  CHECK(cn::mean_ratio({0, 0, 0}, {1, 0, 0}, {3, 0, 0}) == 0);
  CHECK(cn::mean_ratio({1, 1, 1}, {1, 1, 1}, {1, 1, 1}) == 0);
  for (const double s : {1e-200, 1e-3, 1e150}) CHECK(cn::mean_ratio({0, 0, 0}, {s, 0, 0}, {0, 0, s}) == doctest::Approx(h));
}

TEST_CASE("mean_ratio: tets") {
  const cn::vec3 a{1, 1, 1}, b{1, -1, -1}, c{-1, 1, -1}, d{-1, -1, 1};
  CHECK(cn::mean_ratio(a, b, d, c) == doctest::Approx(-cn::mean_ratio(a, b, c, d)));
  CHECK(std::abs(cn::mean_ratio(a, b, c, d)) == doctest::Approx(1));
  const double corner = 12 * std::cbrt(0.25) / 9;  // the volume is 1/6, the squared edges are 1, 1, 1, 2, 2, 2
  CHECK(cn::mean_ratio({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}) == doctest::Approx(corner));
  CHECK(cn::mean_ratio({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}) == doctest::Approx(-corner));
  CHECK(cn::mean_ratio({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}) == 0);
  CHECK(cn::mean_ratio({}, {}, {}, {}) == 0);
  for (const double s : {1e-200, 1e-3, 1e150}) CHECK(cn::mean_ratio({0, 0, 0}, {s, 0, 0}, {0, s, 0}, {0, 0, s}) == doctest::Approx(corner));
}
