// number_text writes numbers with the fewest digits.
#include <concino/core/number_text.hpp>

#include <doctest/doctest.h>

#include <limits>

using concino::core::number_text;

TEST_CASE("number_text: has the fewest digits that read back as the number") {
  CHECK(number_text(0.1) == "0.1");
  CHECK(number_text(1e300) == "1e+300");
  CHECK(number_text(-2.5) == "-2.5");
  CHECK(number_text(1.0 / 3) == "0.3333333333333333");
  CHECK(number_text(std::numeric_limits<double>::infinity()) == "inf");
  CHECK(number_text(42) == "42");
  CHECK(number_text(std::size_t{18446744073709551615u}) == "18446744073709551615");
}
