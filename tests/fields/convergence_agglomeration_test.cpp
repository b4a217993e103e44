// The rows of docs/convergence.tsv on merged Voronoi cells: the coarsest size is computed again, in long runs the two coarsest ones.
#include <concino/solve/ldlt.hpp>

#include <support/agglomeration_table.hpp>
#include <support/corpus.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("convergence: errors on merged cells match the coarsest sizes of the table", M, polygonmesh, polyhedralmesh) {
  const auto table = read_convergence_table();
  std::size_t stored = 0;
  for (const convergence_row& row : table) stored += row.what == "merged" && row.kind == kind_name<M>;
  const auto rows = measure_merged_cells<M>(long_run() ? 2 : 1, [](double) { return ldlt(); });
  CHECK(rows.size() == stored);
  for (const convergence_row& row : rows) {
    CAPTURE(row.discretisation);
    CAPTURE(row.family);
    const auto known = std::find_if(table.begin(), table.end(), [&](const convergence_row& r) {
      return r.what == row.what && r.discretisation == row.discretisation && r.kind == row.kind && r.family == row.family;
    });
    REQUIRE(known != table.end());
    REQUIRE(known->errors.size() == 4);
    for (std::size_t i = 0; i < row.errors.size(); ++i) CHECK(row.errors[i] == doctest::Approx(known->errors[i]).epsilon(0.05));
  }
}

TEST_CASE("convergence: on merged cells errors keep their orders at 70 % fewer cells") {
  std::size_t rows = 0;
  for (const convergence_row& row : read_convergence_table()) {
    if (row.what != "merged") continue;
    CAPTURE(row.discretisation);
    CAPTURE(row.kind);
    CAPTURE(row.family);
    REQUIRE(row.errors.size() == 4);
    ++rows;
    const bool surface = row.kind == "polygons";
    if (row.discretisation == "cells")
      for (std::size_t i = 0; i < 4; ++i) {
        const auto cells = surface ? std::pow(levels<polygonmesh>()[i], 2) : std::pow(levels<polyhedralmesh>()[i], 3);
        CHECK(row.errors[i] == (row.family == "no_merges" ? cells : std::floor(0.3 * cells)));
      }
    else CHECK(order_of(row.errors) >= (row.discretisation == "H1" ? 0.95 : 1.8));
  }
  CHECK(rows == 2 * 3 * 3);
}
