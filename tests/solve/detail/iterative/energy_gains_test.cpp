#include <concino/solve/detail/iterative/energy_gains.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

using concino::detail::energy_gains;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("energy_gains: estimates the rest of a geometric series from two windows") {
  for (const double q : {0.5, 0.9, 0.99}) {
    energy_gains gains;
    CHECK(!gains.has_any());
    CHECK(gains.all() == 0);
    for (int k = 1; k <= 60; ++k) {
      gains.add(std::pow(q, k - 1));
      CHECK(gains.has_any());
      CHECK(gains.all() == doctest::Approx((1 - std::pow(q, k)) / (1 - q)));
      if (k < 8) CHECK(gains.left() == inf);
      else CHECK(gains.left() == doctest::Approx(std::pow(q, k) / (1 - q)).epsilon(1e-9));
    }
  }
}

TEST_CASE("energy_gains: is right for gains that do not decrease, and for gains that vanish at once") {
  for (const double q : {1.0, 1.5}) {
    energy_gains gains;
    for (int k = 0; k < 20; ++k) gains.add(std::pow(q, k));
    CHECK(gains.left() == inf);
  }
  energy_gains zeros, steep;
  for (int k = 0; k < 20; ++k) zeros.add(0);
  CHECK(zeros.left() == inf);
  for (const double gain : {1.0, 1.0, 1.0, 1.0, 1e-6, 1e-6, 1e-6, 1e-6}) steep.add(gain);
  CHECK(steep.left() / (4e-6 * 1e-4) == doctest::Approx(1));
}

TEST_CASE("energy_gains: the last window grows with the number of iterations, from 4 to 64") {
  energy_gains gains;
  double sum_of_all = 0;
  for (int k = 1; k <= 2000; ++k) {
    gains.add(k);
    sum_of_all += k;
    const int window = std::min({k, 4 + k / 24, 64});
    double sum = 0;
    for (int i = k; i > k - window; --i) sum += i;
    CHECK(gains.recent() == sum);
  }
  CHECK(gains.all() == sum_of_all);
}

TEST_CASE("energy_gains: recognises gains that are rounding errors, in any unit") {
  for (const double unit : {1e-60, 1.0, 1e60}) {
    energy_gains gains;
    gains.add(unit);
    CHECK(!gains.is_exhausted());
    gains.add(2e-30 * unit);
    CHECK(!gains.is_exhausted());
    gains.add(0.5e-30 * unit);
    CHECK(gains.is_exhausted());
    CHECK(gains.recent() == 0.5e-30 * unit);
    gains.start();
    CHECK(!gains.has_any());
    CHECK(gains.all() == doctest::Approx(unit));
    CHECK(gains.left() == inf);
    gains.add(1e-40 * unit);
    CHECK(!gains.is_exhausted());
    gains.add(0);
    CHECK(gains.is_exhausted());
  }
  energy_gains zero;
  zero.add(0);
  CHECK(zero.is_exhausted());
}
