#include <concino/render/appearance.hpp>
#include <concino/render/label_colors.hpp>

#include <doctest/doctest.h>

#include <limits>

using namespace concino;

namespace {

/// The distance of two colours in OKLab, in which equal distances look equal.      Source: Ottosson 2020.
double color_distance(const rgb& x, const rgb& y) {
  const auto lab = [](const rgb& c) {
    const double l = std::cbrt(0.4122214708 * c.r + 0.5363325363 * c.g + 0.0514459929 * c.b);
    const double m = std::cbrt(0.2119034982 * c.r + 0.6806995451 * c.g + 0.1073969566 * c.b);
    const double s = std::cbrt(0.0883024619 * c.r + 0.2817188376 * c.g + 0.6299787005 * c.b);
    return std::array{0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s, 1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
                      0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
  };
  const auto a = lab(x), b = lab(y);
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

}  // namespace

TEST_CASE("label_color: twenty labels have distinct colours, which no grey, white or black resembles") {
  CHECK(color_distance({1, 1, 1}, {0, 0, 0}) == doctest::Approx(1).epsilon(1e-3));
  const appearance look;
  for (std::size_t i = 0; i < num_label_colors; ++i) {
    for (std::size_t j = 0; j < i; ++j) CHECK_MESSAGE(color_distance(label_color(i), label_color(j)) > 0.14, i << " and " << j);
    for (const rgb& c : {rgb{1, 1, 1}, rgb{0, 0, 0}, look.color, look.no_value, look.edge_color}) CHECK(color_distance(label_color(i), c) > 0.14);
  }
}

TEST_CASE("label_color: colours repeat after twenty labels") {
  for (std::size_t i = 0; i < num_label_colors; ++i) CHECK(label_color(i + 3 * num_label_colors) == label_color(i));
  CHECK(label_color(std::numeric_limits<std::size_t>::max()) == label_color(15));  // 2^64 - 1 = 20 k + 15
}

TEST_CASE("label_of: whole numbers from 0 are labels, others are not") {
  CHECK(label_of(0) == 0);
  CHECK(label_of(41) == 41);
  for (const double x : {-1.0, 0.5, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN(), 1e300}) CHECK(!label_of(x));
}
