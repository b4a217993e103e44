// Fields on distributed meshes equal those of one process, on any partition. Every test also passes on one process.
#include <concino/adapters/distributed.hpp>
#include <concino/adapters/distributed_harmonic_map.hpp>
#include <concino/adapters/distributed_poisson.hpp>
#include <concino/adapters/distributed_statistics.hpp>

#include <concino/fields/harmonic_map.hpp>
#include <concino/fields/poisson.hpp>
#include <concino/fields/statistics.hpp>
#include <concino/operators/gradient.hpp>
#include <concino/solve/ldlt.hpp>

#include <support/distributed.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;
using namespace distributed_tests;

namespace {

template<class M>
using values_at = std::vector<std::pair<vert_t<M>, double>>;

/// Values on two sides of the unit squares or cubes of two grids.
template<class M>
values_at<M> values_of(const M& m) {
  values_at<M> r;
  for (const auto v : verts(m)) {
    const vec3 p = to_vec3(point(m, v));
    if ((p.x == 0 || p.x == 3) && p.y < 4) r.emplace_back(v, p.x + p.y * p.y);
    if (p.x == 2) r.emplace_back(v, p.y);
  }
  return r;
}

}  // namespace

TEST_CASE_TEMPLATE("distributed: harmonic maps and Poisson's equation equal those of one process", M, CONCINO_ALL_KINDS) {
  const M m = two_grids<M>(3);
  auto load = make_vert_map<double>(m, 0.0);
  for (const auto v : verts(m)) load[v] = point(m, v).x - point(m, v).y;
  const auto u = harmonic_map(m, values_of(m), {.isolated_value = 7}, ldlt());
  const auto w = poisson(m, load, {.values = values_of(m), .isolated_value = 8}, ldlt());
  const auto of_u = gradient(m, u);
  for (const auto& part : parts_of(m)) {
    const distributed<M> d(MPI_COMM_WORLD, is_first() ? m : M(), part);
    auto own_load = make_vert_map<double>(d, 0.0);
    for (const auto v : verts(d)) own_load[v] = point(d, v).x - point(d, v).y;
    for (const petsc_preconditioner p : {petsc_preconditioner::mumps, petsc_preconditioner::gamg}) {
      petsc solver({.preconditioner = p});
      const auto x = harmonic_map(d, values_of(d), {.isolated_value = 7}, solver);
      CHECK(largest_difference(x, u) < 1e-10);
      CHECK(solver.residual() <= 1e-12);
      CHECK(solver.iterations() > 0);
      CHECK(largest_difference(poisson(d, own_load, {.values = values_of(d), .isolated_value = 8}, petsc({.preconditioner = p})), w) < 1e-10);
      // ghosts are up to date, so the gradient needs no messages
      const auto g = gradient(d, x);
      for (const auto q : polys(d)) CHECK(norm(g[q] - of_u[poly_at(m, d.global_number(q))]) < 1e-9);
    }
  }
}

TEST_CASE("distributed: harmonic maps of non-manifold meshes equal those of one process") {
  // three sheets of triangles at one line, and one that touches at a vert
  const trimesh m({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, -1, 0}, {1, -1, 0}, {0, 0, 1}, {1, 0, 1}, {3, 1, 0}, {3, -1, 0}, {4, 0, 0}},
                  {{0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {0, 1, 5}, {1, 6, 5}, {1, 2, 6}, {0, 1, 7}, {1, 8, 7}, {1, 2, 8}, {2, 10, 9}, {10, 11, 9}});
  const auto values_at_ends = [](const auto& mesh) {
    std::vector<std::pair<vert_id, double>> r;
    for (const auto v : verts(mesh)) {
      const vec3 x = point(mesh, v);
      if (x.x == 0 || x.x == 4) r.emplace_back(v, x.x + x.z);
    }
    return r;
  };
  const auto u = harmonic_map(m, values_at_ends(m), {}, ldlt());
  for (const auto& part : parts_of(m)) {
    const distributed<trimesh> d(MPI_COMM_WORLD, is_first() ? m : trimesh(), part);
    const petsc solver({.preconditioner = petsc_preconditioner::mumps});
    CHECK(largest_difference(harmonic_map(d, values_at_ends(d), {}, solver), u) < 1e-10);
    values_at<trimesh> by_number;  // vert_id() where the vert is of other processes
    for (const auto& [v, x] : values_at_ends(m)) by_number.emplace_back(d.vert(number(m, v)), x);
    CHECK(largest_difference(harmonic_map(d, by_number, {}, solver), u) < 1e-10);
  }
}

TEST_CASE_TEMPLATE("distributed: total_measure and statistics equal those of one process", M, CONCINO_KINDS) {
  const M m = two_grids<M>(3);
  auto u = make_vert_map<double>(m, 0.0);
  auto w = make_poly_map<double>(m, 0.0);
  for (const auto v : verts(m)) u[v] = std::sin(3.0 * static_cast<double>(index_of(m, v))) + 1e6;
  for (const auto p : polys(m)) w[p] = std::cos(static_cast<double>(index_of(m, p)));
  u[vert_at(m, 3)] = std::nan("");
  const auto at_verts = statistics(m, u);
  const auto at_polys = statistics(m, w);
  for (const auto& part : parts_of(m)) {
    distributed<M> d(MPI_COMM_WORLD, is_first() ? m : M(), part);
    CHECK(std::abs(total_measure(d) - total_measure(m)) < 1e-12);
    auto x = make_vert_map<double>(d, 0.0);
    auto y = make_poly_map<double>(d, 0.0);
    for (const auto v : verts(d)) x[v] = u[vert_at(m, d.global_number(v))];
    for (const auto p : polys(d)) y[p] = w[poly_at(m, d.global_number(p))];
    const auto check = [](const distributed_statistics& s, const auto& expected, std::uint64_t min_at, std::uint64_t max_at) {
      CHECK(s.min == expected.min);
      CHECK(s.max == expected.max);
      CHECK(s.min_at == min_at);
      CHECK(s.max_at == max_at);
      CHECK(std::abs(s.mean - expected.mean) < 1e-9);
      CHECK(std::abs(s.deviation - expected.deviation) < 1e-9);
      CHECK(std::abs(s.integral - expected.integral) < 1e-8);
      CHECK(s.count == expected.count);
      CHECK(s.not_finite == expected.not_finite);
    };
    check(statistics(d, x), at_verts, number(m, *at_verts.min_at), number(m, *at_verts.max_at));
    check(statistics(d, y), at_polys, number(m, *at_polys.min_at), number(m, *at_polys.max_at));
  }
}

TEST_CASE("distributed: what cannot be solved is the same error on all processes") {
  const trimesh m = two_grids<trimesh>(3);
  const auto part = parts_of(m)[0];
  const distributed<trimesh> d(MPI_COMM_WORLD, is_first() ? m : trimesh(), part);
  values_at<trimesh> of_first;  // of the first grid alone
  for (const auto& [v, x] : values_of(d))
    if (point(d, v).x < 1.5) of_first.emplace_back(v, x);
  CHECK_THROWS_WITH_AS(harmonic_map(d, of_first), "harmonic_map: the component of vert 16 has no prescribed value; give one at any of its verts", solver_error);
  CHECK_THROWS_WITH_AS(harmonic_map(d, values_at<trimesh>()), doctest::Contains("the component of vert 0 has no prescribed value"), solver_error);
  values_at<trimesh> wrong = values_of(d);
  for (const vert_id v : verts(d))
    if (d.global_number(v) == 5) wrong.emplace_back(v, std::nan(""));
  CHECK_THROWS_WITH_AS(harmonic_map(d, wrong), doctest::Contains("harmonic_map: the value given at vert 5 is not finite"), invalid_argument);
  wrong = values_of(d);
  for (const vert_id v : verts(d))
    if (d.global_number(v) == 5 && !d.is_ghost(v)) wrong.insert(wrong.end(), {{v, 1.0}, {v, 2.0}});
  CHECK_THROWS_WITH_AS(harmonic_map(d, wrong), doctest::Contains("vert 5 is given two different values"), invalid_argument);
  CHECK_THROWS_WITH_AS(harmonic_map(d, values_of(d), {.exponent = 0}), "harmonic_map: exponent is 0; it must be 1 or more", invalid_argument);
  CHECK_THROWS_WITH_AS(harmonic_map(d, values_of(d), {}, petsc({.max_iterations = 1})), doctest::Contains("not converged after 1 iterations"), solver_error);
  auto load = make_vert_map<double>(d, 1.0);
  for (const vert_id v : verts(d))
    if (d.global_number(v) == 5) load[v] = HUGE_VAL;
  CHECK_THROWS_WITH_AS(poisson(d, load, {.values = values_of(d)}), doctest::Contains("the load f at vert 5 is not finite"), invalid_argument);
}

TEST_CASE("distributed: values given by the process of a ghost alone count, and all verts may have values") {
  const quadmesh m = grid<quadmesh>(3);
  const auto part = parts_of(m)[1];
  const distributed<quadmesh> d(MPI_COMM_WORLD, is_first() ? m : quadmesh(), part);
  values_at<quadmesh> all, of_ghosts;
  for (const vert_id v : verts(d)) all.emplace_back(v, static_cast<double>(d.global_number(v)));
  const auto u = harmonic_map(d, all);
  for (const vert_id v : verts(d)) CHECK(u[v] == static_cast<double>(d.global_number(v)));
  for (const vert_id v : verts(d))
    if (d.is_ghost(v) || number_of_processes() == 1) of_ghosts.emplace_back(v, 2.0);
  if (sum_of_all(static_cast<double>(of_ghosts.size())) == 0) return;
  const auto w = harmonic_map(d, of_ghosts);
  for (const vert_id v : verts(d)) CHECK(std::abs(w[v] - 2) < 1e-10);
}
