// Problems of 10,000 unknowns on distributed meshes equal those of one process. Every test also passes on one process.
// Of the polygons on 4 processes, MUMPS estimates less memory than it needs.
#include <concino/adapters/distributed.hpp>
#include <concino/adapters/distributed_harmonic_map.hpp>
#include <concino/adapters/distributed_poisson.hpp>
#include <concino/adapters/metis_partition.hpp>

#include <concino/concepts/facets.hpp>
#include <concino/fields/harmonic_map.hpp>
#include <concino/fields/poisson.hpp>

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

/// A mesh of about 10,000 verts.
template<class M>
M large_grid() {
  unsigned n = 10;
  while (grid_arrays<M>(n).points.size() < 9000) ++n;
  return grid<M>(n);
}

double number_at(const vec3& p) { return std::sin(3 * p.x) + p.y * p.y; }

template<class M, class Choose>
auto values_where(const M& m, const Choose& choose) {
  std::vector<std::pair<vert_t<M>, double>> r;
  for (const auto v : verts(m))
    if (choose(to_vec3(point(m, v)))) r.emplace_back(v, number_at(to_vec3(point(m, v))));
  return r;
}
bool is_at_side(const vec3& p) { return p.x == 0; }
bool is_around(const vec3& p) { return p.x == 0 || p.x == 1 || p.y == 0 || p.y == 1; }

/// Also at facets of ghosts, which are not on the boundary of the whole.
template<class M>
auto boundary_fluxes(const M& m) {
  std::vector<std::pair<facet_t<M>, double>> r;
  for (const auto x : facets(m))
    if (is_boundary(m, x)) r.emplace_back(x, number_at(to_vec3(point(m, *adj_facet2v(m, x).begin()))));
  return r;
}

/// The values of solve() on the first process, on all.
template<class M, class F>
vert_map<M, double> on_first(const M& m, const F& solve) {
  auto u = make_vert_map<double>(m, 0.0);
  if (is_first()) u = solve();
  MPI_Bcast(u.data(), static_cast<int>(vert_index_bound(m)), MPI_DOUBLE, 0, MPI_COMM_WORLD);
  return u;
}

petsc direct() { return petsc({.preconditioner = petsc_preconditioner::mumps}); }

template<class M>
distributed<M> divided(const M& m) {
  return {MPI_COMM_WORLD, m, partition(m, static_cast<std::size_t>(number_of_processes()), metis).part};
}

}  // namespace

TEST_CASE_TEMPLATE("distributed: harmonic maps and Poisson's equation of 10,000 unknowns equal those of one process", M, CONCINO_ALL_KINDS) {
  const M m = large_grid<M>();
  const auto values = values_where(m, is_at_side);
  CHECK(num_verts(m) - values.size() > 8000);
  CHECK(num_verts(m) - values.size() < 12'000);
  const auto u = on_first(m, [&] { return harmonic_map(m, values, {}, direct()); });
  const auto w = on_first(m, [&] { return poisson(m, number_at, {.values = values, .fluxes = boundary_fluxes(m)}, direct()); });
  const auto d = divided(m);
  const auto own_values = values_where(d, is_at_side);
  CHECK(largest_difference(harmonic_map(d, own_values, {}, direct()), u) < 1e-10);
  CHECK(largest_difference(poisson(d, number_at, {.values = own_values, .fluxes = boundary_fluxes(d)}, direct()), w) < 1e-10);
}

// The condition of the matrix grows with its power: with values at one side alone it is 1e9, and the maps differ by 2e-10.
TEST_CASE_TEMPLATE("distributed: biharmonic maps of 10,000 unknowns equal those of one process", M, CONCINO_ALL_SURFACE_KINDS) {
  const M m = large_grid<M>();
  const auto u = on_first(m, [&] { return harmonic_map(m, values_where(m, is_around), {.exponent = 2}, direct()); });
  const auto d = divided(m);
  CHECK(largest_difference(harmonic_map(d, values_where(d, is_around), {.exponent = 2}, direct()), u) < 1e-10);
}
