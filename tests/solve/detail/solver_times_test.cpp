#include <concino/solve/detail/solver_times.hpp>

#include <doctest/doctest.h>

#include <initializer_list>

using namespace concino;
using concino::detail::solver_times;

namespace {

/// CPU seconds measured for Laplacians, compiled with -O3 for a server of 2023.
struct measured_times {
  const char* mesh;
  double unknowns, entries, entries_per_cycle, factor_entries, multiplications;
  double ordering, factorization, substitution, levels, iteration;
};

constexpr measured_times measured[] = {
    {"triangles, 40,000", 20068, 80272, 234000, 7.6e5, 1.04e8, 0.033, 0.032, 0.0013, 0.014, 0.0017},
    {"triangles, 457,000", 228608, 914432, 2.73e6, 1.28e7, 4.55e9, 0.62, 2.26, 0.032, 0.20, 0.022},
    {"triangles, 1,111,000", 555520, 2222080, 4.53e6, 3.42e7, 1.91e10, 1.6, 11.0, 0.080, 0.50, 0.042},
    {"quads, 343,000", 342912, 1714560, 4.08e6, 1.72e7, 6.35e9, 0.84, 2.73, 0.043, 0.33, 0.033},
    {"polygons, 229,000", 457216, 3207615, 7.67e6, 5.19e7, 3.76e10, 2.0, 21.8, 0.113, 0.56, 0.063},
    {"tets, 105,000", 19683, 148877, 338000, 4.59e6, 2.35e9, 0.070, 0.82, 0.0081, 0.022, 0.0015},
    {"tets, 998,000", 175616, 1367631, 3.2e6, 1.02e8, 2.17e11, 2.06, 159, 0.168, 0.30, 0.022},
    {"hexes, 27,000", 29791, 391681, 458000, 9.5e6, 7.8e9, 0.17, 3.32, 0.018, 0.051, 0.0022},
    {"hexes, 64,000", 68921, 920241, 1.08e6, 3.0e7, 4.02e10, 0.71, 27, 0.052, 0.132, 0.0054},
    {"polyhedra, 4,900", 27648, 897408, 1.10e6, 2.1e7, 2.9e10, 0.385, 17.5, 0.032, 0.072, 0.0051},
};

}  // namespace

TEST_CASE("solver_times: predictions are within a factor of two of measured times") {
  for (const measured_times& m : measured) {
    INFO(doctest::String(m.mesh));
    const solver_times t{m.unknowns, m.entries};
    const factor_size f{m.factor_entries, m.multiplications};
    const auto check = [](double predicted, double time) {
      CHECK(predicted < 2 * time);
      CHECK(predicted > time / 2);
    };
    check(t.ordering(), m.ordering);
    check(t.factorization(f), m.factorization);
    check(t.substitution(f), m.substitution);
    check(t.levels(), m.levels);
    check(t.iteration(m.entries_per_cycle), m.iteration);
    check(t.iteration(), m.iteration);
  }
}

TEST_CASE("solver_times: iterations are proportional to the digits asked for") {
  CHECK(solver_times::num_iterations(1e-12) == doctest::Approx(20.4));
  CHECK(solver_times::num_iterations(1e-6) == doctest::Approx(10.2));
  CHECK(solver_times::num_iterations(0.9) == 1);
}
