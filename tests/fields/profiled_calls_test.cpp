// Functions of fields open scopes in a profiler: one for the call, and one for each step.
#include <concino/core/profiler.hpp>
#include <concino/fields/harmonic_map.hpp>
#include <concino/fields/poisson.hpp>
#include <concino/fields/smooth.hpp>

#include <support/kinds.hpp>
#include <support/profiled.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

TEST_CASE("profiler: harmonic_map, poisson and smooth open scopes, and give the same results") {
  const auto m = grid<trimesh>(4);
  const std::vector<std::pair<vert_id, double>> ends = {{vert_id{0}, 0.0}, {vert_id{24}, 1.0}};
  profiler p;
  const auto u = harmonic_map(m, ends, {.profiler = &p});
  CHECK(names_of(p) == std::vector<std::string>{"harmonic_map", "-harmonic map", "-factorising", "-solving"});
  const auto plain = harmonic_map(m, ends);
  for (const vert_id v : verts(m)) CHECK(u[v] == plain[v]);
  CHECK(p.entries()[0].calls == 1);

  profiler other;
  poisson(m, u, {.values = ends, .profiler = &other});
  smooth(m, u, 0.01, {.profiler = &other});
  const auto names = names_of(other);
  CHECK(names.front() == "poisson");
  CHECK(std::count(names.begin(), names.end(), "smooth") == 1);
  CHECK(std::count(names.begin(), names.end(), "-solving") == 2);
}

TEST_CASE("profiler: progress is still called, and cancels") {
  const auto m = grid<trimesh>(3);
  profiler p;
  int calls = 0;
  const auto stop = [&](double, const char*) { return ++calls < 2; };
  CHECK_THROWS_AS(harmonic_map(m, {{vert_id{0}, 1.0}}, {.progress = stop, .profiler = &p}), cancelled);
  CHECK(calls == 2);
  CHECK(p.entries()[0].calls == 1);
}
