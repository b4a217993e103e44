// Prepared problems work with every solver.
#include <concino/fields/harmonic_map.hpp>
#include <concino/fields/heat_flow.hpp>
#include <concino/fields/poisson.hpp>
#include <concino/fields/smooth.hpp>

#include <concino/solve.hpp>

#include <support/kinds.hpp>
#include <support/values_at_verts.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace concino;
using namespace concino::testing;

TEST_CASE("prepared problems: every solver gives the same fields") {
  const trimesh m(jittered(grid_arrays<trimesh>(10), 0.02, false));
  const vert_id a{0}, b{50};
  const by_number f;
  const auto h = harmonic_map(m, {{a, 0.0}, {b, 1.0}}), p = poisson(m, f, {.values = {{a, 0.0}, {b, 1.0}}});
  const auto t = heat_flow(m, f, 0.01), s = smooth(m, f, 0.01);
  const auto check = [&](const auto& solver) {
    CHECK(largest_difference(prepare_harmonic_map(m, {a, b}, {}, solver).with_values({{a, 0.0}, {b, 1.0}}), h) < 1e-9);
    CHECK(largest_difference(prepare_poisson(m, {a, b}, {}, solver).solve(f, {.values = {{a, 0.0}, {b, 1.0}}}), p) < 1e-9);
    CHECK(largest_difference(prepare_heat_flow(m, 0.01, {}, solver).advance(f), t) < 1e-9);
    CHECK(largest_difference(prepare_smooth(m, 0.01, {}, solver).apply(f), s) < 1e-9);
  };
  check(ldlt{});
  check(lu{});
  check(conjugate_gradients{});
  check(multigrid{});
  check(auto_solver{});
  const auto_solver small({.max_factor_entries = 10});
  check(small);
  CHECK(prepare_harmonic_map(m, {a}, {}, small).solver().used() == solver_used::multigrid);
  CHECK(prepare_poisson(m, {a}, {}, small).solver().used() == solver_used::multigrid);
  CHECK(prepare_heat_flow(m, 0.01, {}, small).solver().used() == solver_used::multigrid);
  CHECK(prepare_smooth(m, 0.01, {}, small).solver().used() == solver_used::multigrid);
  CHECK(prepare_smooth(m, 0.01).solver().used() == solver_used::ldlt);
  CHECK(prepare_poisson(m, {a}, {}, auto_solver{{.questions = 1000}}).solver().options().questions == 1000);
  auto_solver mine;
  smooth(m, f, 0.01, {}, mine);
  CHECK(mine.used() == solver_used::ldlt);
  auto_solver hers;
  heat_flow(m, f, 0.01, {}, hers);
  CHECK(hers.used() == solver_used::ldlt);
}
