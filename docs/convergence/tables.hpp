// The tables of docs/convergence.md, made of docs/convergence.tsv.
#pragma once

#include <support/convergence_table.hpp>

#include <fmt/core.h>

#include <cmath>
#include <string>

namespace convergence {

inline bool is_of_volumes(const std::string& kind) { return kind == "tets" || kind == "hexes" || kind == "polyhedra"; }

inline bool print_geodesics(bool volumes) {
  fmt::print("| kind | mesh | coarse: mean | largest | fine: mean | largest |\n|---|---|---|---|---|---|\n");
  for (auto row : concino::testing::read_convergence_table()) {
    if (row.what != "geodesics" || is_of_volumes(row.kind) != volumes) continue;
    for (char& c : row.family)
      if (c == '_') c = ' ';
    fmt::print("| {} | {} |", row.kind, row.family);
    for (const double error : row.errors) fmt::print(" {:.2f} |", error);
    fmt::print("\n");
  }
  return true;
}

inline bool print_merged_cells(bool volumes) {
  fmt::print("| cells | merged with | |");
  for (int n = volumes ? 4 : 8; n <= (volumes ? 32 : 64); n *= 2) fmt::print(" {} |", n);
  fmt::print(" order |\n|---|---|---|---|---|---|---|---|\n");
  for (auto row : concino::testing::read_convergence_table()) {
    if (row.what != "merged" || is_of_volumes(row.kind) != volumes) continue;
    const bool counts = row.discretisation == "cells";
    for (char& c : row.family)
      if (c == '_') c = ' ';
    fmt::print("| {} | {} | {} |", row.kind, row.family, counts ? "number" : row.discretisation);
    for (const double error : row.errors) fmt::print(" {} |", counts ? fmt::format("{}", error) : fmt::format("{:.3g}", error));
    fmt::print(" {} |\n", counts ? "" : fmt::format("{:.2f}", concino::testing::order_of(row.errors)));
  }
  return true;
}

/// What a table is of: "gradient surfaces", say. Nothing else is printed.
inline bool print_table(const std::string& which) {
  const std::size_t gap = which.find(' ');
  if (gap == std::string::npos) return false;
  const std::string what = which.substr(0, gap);
  const bool volumes = which.substr(gap + 1) == "volumes", with_discretisation = what == "poisson";
  if (what == "geodesics") return print_geodesics(volumes);
  if (what == "merged") return print_merged_cells(volumes);
  fmt::print("| kind | family |{}", with_discretisation ? " discretisation |" : "");
  for (int n = volumes ? 4 : 8; n <= (volumes ? 32 : 64); n *= 2) fmt::print(" {} |", n);
  fmt::print(" order |\n|---|---|{}---|---|---|---|---|\n", with_discretisation ? "---|" : "");
  for (const auto& row : concino::testing::read_convergence_table()) {
    if (row.what != what || is_of_volumes(row.kind) != volumes) continue;
    fmt::print("| {} | {} |", row.kind, row.family);
    if (with_discretisation) fmt::print(" {} |", row.discretisation);
    for (const double error : row.errors) fmt::print(" {} |", std::isnan(error) ? "-" : fmt::format("{:.3g}", error));
    const double order = concino::testing::order_of(row.errors);
    fmt::print(" {} |\n", std::isnan(order) ? "-" : fmt::format("{:.2f}", order));
  }
  return true;
}

}  // namespace convergence
