// Compares docs/convergence.tsv with the current errors of heat geodesics, on the coarser meshes.
#pragma once

#include <support/geodesic_table.hpp>

#include <doctest/doctest.h>

namespace concino::testing {

template<class M>
void check_geodesics_of() {
  const auto table = read_convergence_table();
  const auto rows = measure_geodesics<M>(coarse_geodesic_mesh);
  std::size_t stored = 0;
  for (const convergence_row& row : table) stored += row.what == "geodesics" && row.kind == kind_name<M>;
  CHECK(rows.size() == stored);
  for (const convergence_row& row : rows) {
    CAPTURE(row.family);
    const auto known = std::find_if(table.begin(), table.end(), [&](const convergence_row& r) {
      return r.what == row.what && r.kind == row.kind && r.family == row.family;
    });
    REQUIRE(known != table.end());
    REQUIRE(known->errors.size() == 4);
    for (const std::size_t i : {0u, 1u}) {
      const double tolerance = 0.01 + 0.05 * known->errors[i];
      CHECK(row.errors[i] <= known->errors[i] + tolerance);
      // The largest error is that of one vert. On graded Voronoi cells it is 0.047 or 0.024, as the last bits of the points are on this system.
      CHECK(row.errors[i] >= (i == 0 ? 1.0 : 0.5) * known->errors[i] - tolerance);
    }
  }
}

}  // namespace concino::testing
