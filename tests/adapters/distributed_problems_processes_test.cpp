// Powers of the Laplacian, values in space and fluxes on distributed meshes, as on one process. Every test also passes on one process.
#include <concino/adapters/distributed.hpp>
#include <concino/adapters/distributed_harmonic_map.hpp>
#include <concino/adapters/distributed_poisson.hpp>

#include <concino/concepts/facets.hpp>
#include <concino/fields/harmonic_map.hpp>
#include <concino/fields/poisson.hpp>
#include <concino/solve/ldlt.hpp>

#include <support/distributed.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;
using namespace distributed_tests;

namespace {

petsc direct() { return petsc({.preconditioner = petsc_preconditioner::mumps}); }

/// f(point) at one side of each of two grids, and at a part of another side.
template<class M, class F>
auto values_of(const M& m, const F& f) {
  std::vector<std::pair<vert_t<M>, decltype(f(vec3()))>> r;
  for (const auto v : verts(m))
    if (const vec3 p = to_vec3(point(m, v)); p.x == 0 || p.x == 3 || (p.y == 0 && p.x < 2.5)) r.emplace_back(v, f(p));
  return r;
}
double number_at(const vec3& p) { return std::sin(3 * p.x) + p.y * p.y; }
vec3 point_at(const vec3& p) { return {p.y * p.y, number_at(p), 1 - p.z * p.x}; }

/// f(centre) at facets of the boundary with a vert of large y. Of a distributed mesh it also takes facets of ghosts, which are not on the boundary of the whole.
template<class M, class F>
auto fluxes_of(const M& m, const F& f) {
  std::vector<std::pair<facet_t<M>, decltype(f(vec3()))>> r;
  for (const auto x : facets(m)) {
    vec3 sum;
    double n = 0;
    for (const auto v : adj_facet2v(m, x)) sum += to_vec3(point(m, v)), ++n;
    if (is_boundary(m, x) && sum.y / n > 0.4) r.emplace_back(x, f(sum / n));
  }
  return r;
}

}  // namespace

TEST_CASE_TEMPLATE("distributed: polyharmonic maps equal those of one process", M, CONCINO_ALL_KINDS) {
  const M m = two_grids<M>(3);
  for (const int exponent : {2, 3}) {
    const auto u = harmonic_map(m, values_of(m, number_at), {.exponent = exponent, .isolated_value = 7}, ldlt());
    for (const auto& part : parts_of(m)) {
      const distributed<M> d(MPI_COMM_WORLD, is_first() ? m : M(), part);
      CHECK(largest_difference(harmonic_map(d, values_of(d, number_at), {.exponent = exponent, .isolated_value = 7}, direct()), u) < 1e-10);
    }
  }
}

TEST_CASE_TEMPLATE("distributed: maps to space and loads that are vectors are those of one process", M, CONCINO_KINDS) {
  const M m = two_grids<M>(3);
  const auto u = harmonic_map<vec3>(m, values_of(m, point_at), {}, ldlt());
  const auto w = poisson(m, point_at, {.values = values_of(m, point_at), .fluxes = fluxes_of(m, point_at)}, ldlt());
  for (const auto& part : parts_of(m)) {
    distributed<M> d(MPI_COMM_WORLD, is_first() ? m : M(), part);
    petsc solver({.preconditioner = petsc_preconditioner::mumps});
    CHECK(largest_difference(harmonic_map<vec3>(d, values_of(d, point_at), {}, solver), u) < 1e-10);
    CHECK(solver.residual() <= 1e-12);
    CHECK(largest_difference(poisson(d, point_at, {.values = values_of(d, point_at), .fluxes = fluxes_of(d, point_at)}, direct()), w) < 1e-10);
  }
}

TEST_CASE_TEMPLATE("distributed: fluxes count once, whatever the partition", M, CONCINO_ALL_KINDS) {
  const M m = two_grids<M>(3);
  const auto u = poisson(m, number_at, {.values = values_of(m, number_at), .fluxes = fluxes_of(m, number_at)}, ldlt());
  const auto without = poisson(m, number_at, {.values = values_of(m, number_at)}, ldlt());
  for (const auto& part : parts_of(m)) {
    const distributed<M> d(MPI_COMM_WORLD, is_first() ? m : M(), part);
    const auto x = poisson(d, number_at, {.values = values_of(d, number_at), .fluxes = fluxes_of(d, number_at)}, direct());
    CHECK(largest_difference(x, u) < 1e-10);
    CHECK(sum_of_all(largest_difference(x, without)) > 0.01);
  }
}

TEST_CASE_TEMPLATE("distributed: meshes in any unit have the same solutions", M, CONCINO_VOLUME_KINDS) {
  const M m = grid<M>(3);
  auto a = grid_arrays<M>(3);
  for (vec3& p : a.points) p *= 0x1p-300;
  const M small(std::move(a));
  const auto part = parts_of(m)[1];
  const distributed<M> d(MPI_COMM_WORLD, m, part), e(MPI_COMM_WORLD, small, part);
  const auto scaled = [](double by, auto pairs) {
    for (auto& [x, value] : pairs) value *= by;
    return pairs;
  };
  const auto u = harmonic_map(d, values_of(d, number_at), {.exponent = 2}, direct());
  const auto w = poisson(d, number_at, {.values = values_of(d, number_at), .fluxes = fluxes_of(d, number_at)}, direct());
  const auto u_small = harmonic_map(e, values_of(d, number_at), {.exponent = 2}, direct());
  const auto w_small = poisson(e, [](const vec3& p) { return number_at(0x1p300 * p) * 0x1p600; },
                               {.values = values_of(d, number_at), .fluxes = scaled(0x1p300, fluxes_of(d, number_at))}, direct());
  for (const auto v : verts(d)) {
    CHECK(std::abs(u_small[v] - u[v]) < 1e-10);
    CHECK(std::abs(w_small[v] - w[v]) < 1e-10);
  }
}

TEST_CASE("distributed: wrong values and fluxes are the same error on all processes") {
  const quadmesh m = grid<quadmesh>(3);
  const distributed<quadmesh> d(MPI_COMM_WORLD, is_first() ? m : quadmesh(), parts_of(m)[0]);
  auto values = values_of(d, point_at);
  const auto with = [&](std::uint64_t vert, const vec3& x) {
    auto r = values;
    for (const vert_id v : verts(d))
      if (d.global_number(v) == vert && !d.is_ghost(v)) r.emplace_back(v, x);
    return r;
  };
  CHECK_THROWS_WITH_AS(harmonic_map<vec3>(d, with(0, point_at({0, 0, 0}) + vec3{0, 0, 1})), "harmonic_map: vert 0 is given two different values", invalid_argument);
  CHECK_THROWS_WITH_AS(harmonic_map<vec3>(d, with(10, {0, std::nan(""), 1})), "harmonic_map: the value given at vert 10 is not finite", invalid_argument);
  CHECK_THROWS_WITH_AS(poisson(d, [](const vec3& p) { return vec3{0, p.x > 0.9 && p.y < 0.1 ? HUGE_VAL : 0, 0}; }, {.values = values}),
                       doctest::Contains("poisson: the load f at vert 3 is not finite"), invalid_argument);

  using flux_list = std::vector<std::pair<edge_id, double>>;
  const auto of_edge = [&](std::uint64_t a, std::uint64_t b, std::vector<double> given) {  // by each process that has the edge
    flux_list r;
    for (const edge_id e : edges(d)) {
      std::uint64_t sum = 0, product = 1;
      for (const vert_id v : adj_e2v(d, e)) sum += d.global_number(v), product *= d.global_number(v);
      if (sum == a + b && product == a * b)
        for (const double x : given) r.emplace_back(e, x);
    }
    return r;
  };
  const auto numbers = values_of(d, number_at);
  const auto solve = [&](const flux_list& fluxes) { return poisson(d, number_at, {.values = numbers, .fluxes = fluxes}); };
  CHECK_THROWS_WITH_AS(solve(of_edge(14, 15, {1.0, 2.0})), doctest::Contains("poisson: the flux given at the edge of verts 14, 15 differs"), invalid_argument);
  CHECK_THROWS_WITH_AS(solve(of_edge(14, 15, {std::nan("")})), doctest::Contains("the edge of verts 14, 15 is not finite"), invalid_argument);
  CHECK_THROWS_WITH_AS(solve(of_edge(5, 6, {1.0})), doctest::Contains("the edge of verts 5, 6, which has 2 polys"), invalid_mesh);
  CHECK_THROWS_WITH_AS(solve({{edge_id{1000}, 1.0}}), "poisson: a flux is given at what is no edge or face of this process", invalid_mesh);
  CHECK(num_verts(solve(of_edge(14, 15, {1.0, 1.0})).mesh()) == num_verts(d));
}

TEST_CASE("distributed: problems of meshes without elements, and of polys without area") {
  const trimesh none;
  const distributed<trimesh> empty(MPI_COMM_WORLD, none, make_poly_map<int>(none, 0));
  CHECK(harmonic_map(empty, {}, {.exponent = 2}).values().size() == 0);
  CHECK(poisson(empty, number_at).values().size() == 0);
  const trimesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {3, 0, 0}, {3, 0, 0}}, {{0, 1, 2}, {2, 3, 4}});
  const distributed<trimesh> d(MPI_COMM_WORLD, m, make_poly_map<int>(m, 0));
  CHECK_THROWS_WITH_AS(harmonic_map(d, values_of(d, number_at), {.exponent = 2}), doctest::Contains("is degenerate"), invalid_mesh);
}
