#include <concino/print/hatch.hpp>

#include <concino/core/error.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace concino;

namespace {

using contour = std::vector<slice_point>;

contour rectangle(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

double length_of(const slice_lines& h) {
  double sum = 0;
  for (std::size_t i = 0; i < h.size(); ++i)
    for (std::size_t k = 0; k + 1 < h[i].size(); k += 2) sum += std::hypot(h[i][k + 1][0] - h[i][k][0], h[i][k + 1][1] - h[i][k][1]);
  return sum;
}

}  // namespace

TEST_CASE("hatch: lines across a square with a hole") {
  slice_layer layer;
  layer.outer.push_back(rectangle(0, 0, 4, 4));
  layer.inner.push_back(rectangle(1, 1, 2, 2));
  const slice_lines h = hatch(layer, 1, 0);
  REQUIRE(h.size() == 1);
  const contour expected{{0, 0.5}, {4, 0.5}, {4, 1.5}, {2, 1.5}, {1, 1.5}, {0, 1.5}, {0, 2.5}, {4, 2.5}, {4, 3.5}, {0, 3.5}};
  CHECK(contour(h[0].begin(), h[0].end()) == expected);
  CHECK(length_of(hatch(layer, 1, 90)) == 15);
  CHECK(length_of(hatch(layer, 1, -90)) == 15);
  CHECK(length_of(hatch(layer, 1, 180)) == 15);
  CHECK(hatch({}, 1, 0).empty());
  layer.inner.push_back(rectangle(-1, -1, 5, 5));
  CHECK(hatch(layer, 1, 0).empty());
}

TEST_CASE("hatch: contours in any direction, that overlap or cross themselves, by the rule of layers") {
  slice_layer layer;
  layer.outer.push_back(contour{{0, 0}, {0, 4}, {4, 4}, {4, 0}});  // clockwise
  layer.outer.push_back(rectangle(2, 0, 6, 4));                    // overlaps
  layer.inner.push_back(rectangle(1, 1, 3, 3));                    // leaves 2 to 3, which is twice inside
  CHECK(length_of(hatch(layer, 0.5, 0)) * 0.5 == 24 - 2);
  slice_layer eight;
  eight.outer.push_back(contour{{0, 0}, {2, 2}, {2, 0}, {0, 2}});
  CHECK(length_of(hatch(eight, 0.01, 90)) * 0.01 == doctest::Approx(2).epsilon(1e-3));
}

TEST_CASE("hatch: length times distance converges to the area at any angle, and no segment leaves the material") {
  slice_layer layer;
  contour disk, hole;
  for (int i = 0; i < 200; ++i) disk.push_back({3 + 2 * std::cos(i * 0.0314159265358979324), -1 + 2 * std::sin(i * 0.0314159265358979324)});
  for (int i = 0; i < 100; ++i) hole.push_back({3 + std::cos(i * 0.0628318530717958648), -1 + std::sin(i * 0.0628318530717958648)});
  layer.outer.push_back(disk);
  layer.inner.push_back(hole);
  const double area = 100 * 4 * std::sin(0.0314159265358979324) - 50 * std::sin(0.0628318530717958648);
  for (const double angle : {0.0, 17.0, 45.0, 90.0, 200.0, -33.0}) {
    const slice_lines h = hatch(layer, 0.01, angle);
    CHECK(length_of(h) * 0.01 == doctest::Approx(area).epsilon(1e-3));
    for (const slice_point& p : h[0]) {
      const double r = std::hypot(p[0] - 3, p[1] + 1);
      CHECK((std::abs(r - 1) < 1e-3 || std::abs(r - 2) < 1e-3));
    }
    for (std::size_t k = 0; k + 1 < h[0].size(); k += 2) {
      const double a = std::atan2(h[0][k + 1][1] - h[0][k][1], h[0][k + 1][0] - h[0][k][0]) * 180 / 3.14159265358979324;
      CHECK(std::abs(std::remainder(a - angle, 180)) < 1e-6);
    }
  }
}

TEST_CASE("hatch: lines through points of contours") {
  slice_layer layer;  // points on the lines y = 0.5 and 1.5
  layer.outer.push_back(contour{{0, 0.5}, {2, 0.5}, {3, 1.5}, {2, 2.5}, {0, 2.5}, {1, 1.5}});
  const slice_lines h = hatch(layer, 1, 0);
  REQUIRE(h.size() == 1);
  double sum = 0;
  for (std::size_t k = 0; k + 1 < h[0].size(); k += 2) sum += std::abs(h[0][k + 1][0] - h[0][k][0]);
  CHECK(sum == 4);  // one of the lines at the bottom and the top counts
}

TEST_CASE("hatch: wrong arguments") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  slice_layer layer;
  layer.outer.push_back(rectangle(0, 0, 1, 1));
  for (const double d : {0.0, -1.0, nan, std::numeric_limits<double>::infinity(), 1e-12}) CHECK_THROWS_AS((void)hatch(layer, d, 0), invalid_argument);
  CHECK_THROWS_AS((void)hatch(layer, 1, nan), invalid_argument);
  layer.inner.push_back(contour{{0, 0}, {nan, 1}});
  CHECK_THROWS_WITH_AS((void)hatch(layer, 1, 0), "hatch: inner contour 0 has a point that is not finite", invalid_argument);
}
