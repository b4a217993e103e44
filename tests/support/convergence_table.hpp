// Reads and writes docs/convergence.tsv: the errors that docs/convergence.md shows and that tests compute again. A line has the quantity, the
// discretisation, the kind of mesh, the family, and the error for each size, or - if the discretisation does not support a poly. For geodesics
// it has the mesh, with _ for blanks, and the mean and largest error on a coarse mesh and on a fine one. For merged cells it has cells (their number), H1 or
// L2, and how they were merged.
#pragma once

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace concino::testing {

struct convergence_row {
  std::string what, discretisation, kind, family;
  std::vector<double> errors = {};  // not a number: unsupported
};

inline std::filesystem::path convergence_table_path() {
  return std::filesystem::path(__FILE__).parent_path().parent_path().parent_path() / "docs" / "convergence.tsv";
}

inline std::vector<convergence_row> read_convergence_table() {
  std::ifstream file(convergence_table_path());
  std::vector<convergence_row> rows;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    convergence_row row;
    words >> row.what >> row.discretisation >> row.kind >> row.family;
    for (std::string error; words >> error;) row.errors.push_back(error == "-" ? std::numeric_limits<double>::quiet_NaN() : std::stod(error));
    rows.push_back(row);
  }
  if (rows.empty()) throw std::runtime_error("cannot read " + convergence_table_path().string());
  return rows;
}

/// The order of convergence: the slope of the straight line fitted to the three finest sizes in a log-log plot. Sizes double.
inline double order_of(const std::vector<double>& errors) {
  const std::size_t n = errors.size();
  return std::log2(errors[n - 3] / errors[n - 1]) / 2;  // the middle one does not change the slope
}

}  // namespace concino::testing
