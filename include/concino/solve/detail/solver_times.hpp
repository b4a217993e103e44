// A model of the time that factorisation and iteration take, with which auto_solver chooses.
#pragma once

#include <concino/solve/ldlt.hpp>

#include <algorithm>
#include <cmath>

namespace concino::detail {

/// CPU seconds that ldlt and multigrid take for a matrix, on one core of a server of 2023. Only their ratios matter for a choice. The constants are fitted to
/// 30 measured matrices, of surfaces and volumes with 10^3 to 10^6 unknowns; most times are within a factor of 1.5. The rows auto.* of benchmarks/ print
/// predictions beside times.
struct solver_times {
  double unknowns = 0, entries = 0;  // of the lower triangle

  /// Everything about a factor except its numbers.
  double ordering() const { return 2e-7 * entries; }
  double factorization(const factor_size& f) const { return 4.5e-10 * f.multiplications + 3e-8 * unknowns; }
  double substitution(const factor_size& f) const { return 2e-9 * f.entries + 1.2e-8 * unknowns; }

  double levels() const { return 7e-8 * entries + 3.5e-7 * unknowns; }
  /// One iteration of multigrid. entries_per_cycle: of the matrices that a cycle visits; at first a typical number. Matrices that stay in the cache take about
  /// half of the time.
  double iteration(double entries_per_cycle) const {
    constexpr double cached = 4e6;  // entries
    const double visited = entries + entries_per_cycle;
    return (0.45 + 0.55 * std::min(1.0, visited / cached)) * (1.7e-9 * visited + 4.2e-8 * unknowns);
  }
  double iteration() const { return iteration(2 * entries); }
  static double num_iterations(double tolerance) { return std::max(1.0, -1.7 * std::log10(tolerance)); }
};

}  // namespace concino::detail
