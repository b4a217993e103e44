// Errors of Poisson's equation on Voronoi cells before and after agglomerate_while, for docs/convergence.md and for the tests that compare with it.
#pragma once

#include <concino/edit/agglomerate_while.hpp>
#include <concino/edit/min_stability.hpp>

#include <support/convergence.hpp>

#include <string>
#include <vector>

namespace concino::testing {

inline constexpr double limit_of_merged_cells = 0.05;  // of min_stability

/// How cells are merged until 30 % of them are left: not at all, without an invariant, or with min_stability.
inline constexpr const char* ways_to_merge[] = {"no_merges", "no_invariant", "min_stability"};

template<class M>
M make_merged_cells(const std::string& way, std::size_t n) {
  M m = make_family<M>(family::voronoi, n);
  const agglomerate_while_options options{.target = 3 * num_polys(m) / 10};
  if (way == "no_invariant") agglomerate_while(m, [](const proposed_edit&) { return permission{}; }, options);
  if (way == "min_stability") agglomerate_while(m, min_stability(limit_of_merged_cells), options);
  return m;
}

/// Three rows for each way to merge, for the first `sizes` sizes: the cells that are left, and the errors. make_solver(tolerance) returns the solver.
template<class M, class MakeSolver>
std::vector<convergence_row> measure_merged_cells(std::size_t sizes, const MakeSolver& make_solver) {
  std::vector<convergence_row> rows;
  for (const char* way : ways_to_merge) {
    convergence_row row{"merged", "cells", kind_name<M>, way}, h1 = row, l2 = row;
    h1.discretisation = "H1", l2.discretisation = "L2";
    for (std::size_t i = 0; i < sizes; ++i) {
      const M m = make_merged_cells<M>(way, levels<M>()[i]);
      const auto u = solve_poisson(m, virtual_elements, make_solver(1e-9));
      row.errors.push_back(static_cast<double>(num_polys(m)));
      h1.errors.push_back(gradient_error(m, u));
      l2.errors.push_back(value_error(m, u));
    }
    rows.insert(rows.end(), {row, h1, l2});
  }
  return rows;
}

}  // namespace concino::testing
