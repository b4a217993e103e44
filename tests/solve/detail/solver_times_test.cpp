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
    {"triangles, 20,000", 10000, 40000, 7.3e4, 3.32e5, 4.34e7, 0.0048, 0.0137, 0.00043, 0.0049, 0.00043},
    {"triangles, 60,000", 30080, 120320, 2.38e5, 8.87e5, 1.38e8, 0.015, 0.11, 0.0019, 0.014, 0.0014},
    {"triangles, 457,000", 228608, 914432, 1.83e6, 1.12e7, 4.52e9, 0.14, 1.94, 0.032, 0.11, 0.010},
    {"triangles, 1,111,000", 555520, 2222080, 4.52e6, 3.16e7, 2.16e10, 0.41, 9.32, 0.089, 0.29, 0.033},
    {"quads, 343,000", 342912, 1714560, 2.89e6, 1.56e7, 6.73e9, 0.23, 2.99, 0.045, 0.20, 0.018},
    {"polygons, 229,000", 457216, 3207615, 5.44e6, 4.95e7, 4.54e10, 0.55, 20.5, 0.12, 0.38, 0.039},
    {"tets, 25,000", 4913, 35937, 5.54e4, 4.88e5, 8.66e7, 0.0041, 0.0476, 0.00061, 0.0042, 0.00020},
    {"tets, 105,000", 19683, 148877, 2.43e5, 4.67e6, 2.69e9, 0.025, 0.893, 0.0065, 0.016, 0.00090},
    {"tets, 998,000", 175616, 1367631, 2.28e6, 1.02e8, 2.17e11, 0.54, 159, 0.168, 0.17, 0.011},
    {"hexes, 8,000", 9261, 118121, 1.26e5, 1.81e6, 7.09e8, 0.012, 0.254, 0.0019, 0.0081, 0.00045},
    {"hexes, 27,000", 29791, 391681, 4.25e5, 1.05e7, 8.93e9, 0.054, 3.08, 0.017, 0.028, 0.0016},
    {"hexes, 64,000", 68921, 920241, 9.97e5, 3.0e7, 4.02e10, 0.17, 27, 0.052, 0.073, 0.0037},
    {"polyhedra, 4,900", 27648, 897408, 1.00e6, 2.04e7, 2.61e10, 0.11, 15.1, 0.034, 0.042, 0.0037},
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
