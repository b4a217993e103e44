// Heat flow and isosurfaces of distributed meshes equal those of one process. Every test also passes on one process.
#include <concino/adapters/distributed.hpp>
#include <concino/adapters/distributed_heat_flow.hpp>
#include <concino/adapters/distributed_statistics.hpp>

#include <concino/fields/heat_flow.hpp>
#include <concino/level_sets/isosurface.hpp>
#include <concino/solve/ldlt.hpp>

#include <support/distributed.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;
using namespace distributed_tests;

TEST_CASE_TEMPLATE("distributed: heat flow equals that of one process", M, CONCINO_ALL_KINDS) {
  const M m = two_grids<M>(3);
  auto u = make_vert_map<double>(m, 0.0);
  for (const auto v : verts(m)) u[v] = std::sin(static_cast<double>(index_of(m, v)));
  for (const bool is_fixed : {false, true}) {
    const heat_scheme scheme = is_fixed ? heat_scheme::second_order : heat_scheme::backward_euler;
    const auto expected =
        heat_flow(m, u, 0.02, {.fixed = is_fixed ? std::vector{vert_at(m, 0), vert_at(m, 9)} : std::vector<vert_t<M>>(), .steps = 2, .scheme = scheme}, ldlt());
    for (const auto& part : parts_of(m)) {
      const distributed<M> d(MPI_COMM_WORLD, is_first() ? m : M(), part);
      auto x = make_vert_map<double>(d, 0.0);
      heat_flow_options<distributed<M>> options{.steps = 2, .scheme = scheme};
      for (const auto v : verts(d)) {
        x[v] = d.is_ghost(v) ? std::nan("") : u[vert_at(m, d.global_number(v))];
        if (is_fixed && !d.is_ghost(v) && (d.global_number(v) == 0 || d.global_number(v) == 9)) options.fixed.push_back(v);
      }
      const auto y = heat_flow(d, x, 0.02, options, petsc({.preconditioner = petsc_preconditioner::mumps}));
      double worst = 0;
      for (const auto v : verts(d)) worst = std::max(worst, std::abs(y[v] - expected[vert_at(m, d.global_number(v))]));
      CHECK(worst < 1e-10);
    }
  }
}

TEST_CASE_TEMPLATE("distributed: vectors flow as on one process, in any unit, and verts without polys are not read", M, CONCINO_KINDS) {
  const M m = two_grids<M>(3);  // the last vert has no polys
  auto a = two_grids_arrays<M>(3);
  for (vec3& p : a.points) p *= 0x1p-300;
  const M small(std::move(a));
  const auto at = [](const vec3& p) { return p.z == 5 ? vec3{0, std::nan(""), 1} : vec3{std::sin(3 * p.x), p.y * p.y, p.x + p.z}; };
  const auto expected = heat_flow(m, at, 0.02, {.steps = 2}, ldlt());
  for (const auto& part : parts_of(m)) {
    const distributed<M> d(MPI_COMM_WORLD, m, part), e(MPI_COMM_WORLD, small, part);
    const auto u = heat_flow(d, at, 0.02, {.steps = 2}, petsc({.preconditioner = petsc_preconditioner::mumps}));
    const auto u_small = heat_flow(e, [&](const vec3& p) { return at(0x1p300 * p); }, std::ldexp(0.02, -600), {.steps = 2},
                                   petsc({.preconditioner = petsc_preconditioner::mumps}));
    for (const auto v : verts(d)) {
      if (num_elements(adj_v2p(d, v)) == 0) continue;
      CHECK(norm(u[v] - expected[vert_at(m, d.global_number(v))]) < 1e-10);
      CHECK(norm(u_small[v] - u[v]) < 1e-10);
    }
  }
}

TEST_CASE("distributed: what heat flow refuses is the same error on all processes") {
  const quadmesh m = grid<quadmesh>(3);
  const distributed<quadmesh> d(MPI_COMM_WORLD, is_first() ? m : quadmesh(), parts_of(m)[0]);
  auto u = make_vert_map<double>(d, 1.0);
  CHECK_THROWS_WITH_AS(heat_flow(d, u, -1.0), doctest::Contains("time is -1"), invalid_argument);
  CHECK_THROWS_WITH_AS(heat_flow(d, u, 1.0, {.steps = 0}), doctest::Contains("steps is 0"), invalid_argument);
  for (const vert_id v : verts(d))
    if (d.global_number(v) == 7 && !d.is_ghost(v)) u[v] = std::nan("");
  CHECK_THROWS_WITH_AS(heat_flow(d, u, 1.0), doctest::Contains("the initial value at vert 7 is not finite"), invalid_argument);
}

TEST_CASE_TEMPLATE("distributed: the isosurfaces of all parts make up that of the whole", M, CONCINO_VOLUME_KINDS) {
  const M m = grid<M>(4);
  const auto value = [](const vec3& p) { return p.x * p.x + p.y * p.y + 0.7 * p.z; };
  auto u = make_vert_map<double>(m, 0.0);
  for (const auto v : verts(m)) u[v] = value(to_vec3(point(m, v)));
  const auto whole = isosurface(m, u, 0.6);
  for (const auto& part : parts_of(m)) {
    const distributed<M> d(MPI_COMM_WORLD, is_first() ? m : M(), part);
    auto x = make_vert_map<double>(d, 0.0);
    for (const auto v : verts(d)) x[v] = value(to_vec3(point(d, v)));
    const auto own = owned_part(d);
    const auto piece = isosurface(own, x, 0.6);
    CHECK(std::abs(sum_of_all(total_measure(piece.mesh)) - total_measure(whole.mesh)) < 1e-12);
    CHECK(sum_of_all(static_cast<double>(num_polys(piece.mesh))) == static_cast<double>(num_polys(whole.mesh)));
  }
}
