// Functions of fields about heat, and those that prepare, open scopes in a profiler.
#include <concino/fields/heat_flow.hpp>
#include <concino/fields/heat_geodesics.hpp>
#include <concino/fields/log_map.hpp>
#include <concino/fields/parallel_transport.hpp>
#include <concino/fields/poisson.hpp>
#include <concino/fields/smooth.hpp>

#include <support/kinds.hpp>
#include <support/profiled.hpp>

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

using names = std::vector<std::string>;

}  // namespace

TEST_CASE("profiler: heat_flow, heat_geodesics, log_map and parallel_transport open one scope each") {
  const auto m = grid<trimesh>(3);
  profiler p;
  heat_flow(m, make_vert_map<double>(m, 1.0), 0.1, {.steps = 2, .profiler = &p});
  CHECK(names_of(p) == names{"heat_flow", "-heat flow", "-factorising"});
  profiler q;
  const auto d = heat_geodesics(m, {vert_id{0}}, {.profiler = &q});
  CHECK(names_of(q) == names{"heat_geodesics", "-heat geodesics", "-factorising"});
  CHECK(q.entries()[0].calls == 1);
  const auto plain = heat_geodesics(m, {vert_id{0}});
  for (const vert_id v : verts(m)) CHECK(d[v] == plain[v]);
  profiler r;
  log_map(m, vert_id{0}, {.profiler = &r});
  parallel_transport(m, {{vert_id{0}, {1, 0}}}, {.profiler = &r});
  CHECK(names_of(r) == names{"log_map", "-log map", "parallel_transport", "-parallel transport"});
}

TEST_CASE("profiler: functions that prepare open scopes under their names") {
  const auto m = grid<trimesh>(3);
  profiler p;
  prepare_heat_flow(m, 0.1, {.profiler = &p});
  prepare_heat_geodesics(m, {.profiler = &p});
  prepare_log_map(m, {.profiler = &p});
  prepare_parallel_transport(m, {.profiler = &p});
  prepare_poisson(m, {vert_id{0}}, {.profiler = &p});
  prepare_smooth(m, 0.1, {.profiler = &p});
  names calls, steps;
  for (const auto& e : p.entries()) (e.depth == 0 ? calls : steps).push_back(e.name);
  CHECK(calls == names{"prepare_heat_flow", "prepare_heat_geodesics", "prepare_log_map", "prepare_parallel_transport", "prepare_poisson", "prepare_smooth"});
  CHECK(steps.size() > calls.size());
}
