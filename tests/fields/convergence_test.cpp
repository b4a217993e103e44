#include <support/convergence_table.hpp>

#include <doctest/doctest.h>

using namespace concino::testing;

TEST_CASE("convergence: virtual elements and the gradient have their orders on every kind and family") {
  std::size_t rows = 0;
  for (const convergence_row& row : read_convergence_table()) {
    CAPTURE(row.what);
    CAPTURE(row.kind);
    CAPTURE(row.family);
    REQUIRE(row.errors.size() == 4);
    if (row.discretisation != "virtual_elements" && row.what != "gradient") continue;
    ++rows;
    CHECK(order_of(row.errors) >= (row.what == "gradient" ? 0.9 : row.what == "poisson" && row.family == "regular" ? 1.9 : 1.8));
  }
  CHECK(rows == 3 * 24);
}
