#include <concino/render/value_scale.hpp>

#include <doctest/doctest.h>

#include <limits>

using namespace concino;

TEST_CASE("value_scale: a linear scale is proportional") {
  const value_scale s = value_scale::linear(2, 6);
  CHECK(s(2) == 0);
  CHECK(s(3) == 0.25);
  CHECK(s(6) == 1);
  CHECK(s(-100) == 0);
  CHECK(s(100) == 1);
  CHECK(s.slope(4) == 0.25);
  CHECK(s.slope(7) == 0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const value_scale t = value_scale::linear(std::vector<double>{5, nan, -1, std::numeric_limits<double>::infinity(), 2});
  CHECK(t.low() == -1);
  CHECK(t.high() == 5);
  CHECK_THROWS_AS(value_scale::linear(1, 0), invalid_argument);
  CHECK_THROWS_AS(value_scale::linear(0, nan), invalid_argument);
  CHECK_THROWS_AS(value_scale::equalized({}, 2), invalid_argument);
}

TEST_CASE("value_scale: an equalised scale increases and gives equal parts to equally many values") {
  std::vector<double> values;
  for (int i = 0; i <= 4800; ++i) values.push_back(std::exp(i / 400.0));  // dense near 1, sparse near exp(12)
  for (const double share : {0.0, 0.5, 1.0}) {
    const value_scale s = value_scale::equalized(values, share);
    CHECK(s(values.front()) == doctest::Approx(0));
    CHECK(s(values.back()) == doctest::Approx(1));
    for (std::size_t i = 1; i < values.size(); ++i) {
      CHECK_MESSAGE(s(values[i]) > s(values[i - 1]), i);
      if (i % 97 == 0) {
        const double h = values[i] * 1e-7;
        CHECK(s.slope(values[i]) == doctest::Approx((s(values[i] + h) - s(values[i] - h)) / (2 * h)).epsilon(1e-4));
      }
    }
    const double middle = values[2400], linear = (middle - values.front()) / (values.back() - values.front());
    CHECK(s(middle) == doctest::Approx(share * 0.5 + (1 - share) * linear));
  }
}

TEST_CASE("value_scale: equal values have one position; the extrema are the ends") {
  std::vector<double> values(100, 0.0);
  for (int i = 1; i <= 20; ++i) values.push_back(i);
  values.insert(values.end(), 50, 7.0);
  const value_scale s = value_scale::equalized(values, 1);
  CHECK(s(0) == 0);
  CHECK(s(20) == 1);
  CHECK(s(7) > s(6.9));
  CHECK(s(7.1) > s(7));
  CHECK(s(7 - 1e-9) == doctest::Approx(s(7)));
}

TEST_CASE("value_scale: accepts one value, no value and huge values") {
  CHECK(value_scale::equalized(std::vector<double>{3, 3, 3})(3) == 0.5);
  CHECK(value_scale::equalized({})(0.25) == 0.25);
  const value_scale s = value_scale::equalized(std::vector<double>{-1e308, 0, 1e308});
  CHECK(s(-1e308) == doctest::Approx(0));
  CHECK(s(1e308) == doctest::Approx(1));
}
