// Compares docs/convergence.tsv with the current errors of the operators, for the coarsest sizes.
#pragma once

#include <concino/solve/ldlt.hpp>

#include <support/convergence.hpp>
#include <support/corpus.hpp>

#include <doctest/doctest.h>

namespace concino::testing {

/// Computes the rows of a kind for its coarsest size again, and in long runs for its two coarsest sizes.
template<class M>
void check_convergence_of() {
  const auto table = read_convergence_table();
  std::size_t stored = 0, computed = 0;
  for (const convergence_row& row : table) stored += row.kind == kind_name<M> && row.what != "geodesics" && row.what != "merged";
  for (const family f : families<M>()) {
    const auto rows = measure_convergence<M>(f, long_run() ? 2 : 1, [](double) { return ldlt(); });
    for (const convergence_row& row : rows) {
      CAPTURE(row.what);
      CAPTURE(row.discretisation);
      CAPTURE(row.family);
      ++computed;
      const auto known = std::find_if(table.begin(), table.end(), [&](const convergence_row& r) {
        return r.what == row.what && r.discretisation == row.discretisation && r.kind == row.kind && r.family == row.family;
      });
      REQUIRE(known != table.end());
      REQUIRE(known->errors.size() == 4);
      for (std::size_t i = 0; i < row.errors.size(); ++i) {
        CHECK(std::isnan(row.errors[i]) == std::isnan(known->errors[i]));
        if (!std::isnan(row.errors[i])) CHECK(row.errors[i] == doctest::Approx(known->errors[i]).epsilon(0.05));
      }
    }
  }
  CHECK(computed == stored);
}

}  // namespace concino::testing
