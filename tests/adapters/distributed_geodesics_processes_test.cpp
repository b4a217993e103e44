// Heat geodesics on distributed meshes equal those of one process, on any partition. Every test also passes on one
// process.
#include <concino/adapters/distributed.hpp>
#include <concino/adapters/distributed_heat_geodesics.hpp>

#include <concino/fields/heat_geodesics.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/solve/ldlt.hpp>

#include <support/distributed.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;
using namespace distributed_tests;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template<class M>
using sources_of = std::vector<std::pair<vert_t<M>, double>>;

/// The sources of the whole mesh among the verts of this process.
template<class M>
sources_of<distributed<M>> own_sources(const distributed<M>& d, const sources_of<M>& sources) {
  sources_of<distributed<M>> own;
  for (const auto v : verts(d))
    for (const auto& [w, x] : sources)
      if (d.global_number(v) == w.raw() && !d.is_ghost(v)) own.emplace_back(v, x);
  return own;
}

/// The largest difference at local verts, relative to the largest distance.
template<class M>
double difference(const M& m, const vert_map<distributed<M>, double>& found, const vert_map<M, double>& expected) {
  double worst = 0, largest = 0;
  for (const double x : expected.values())
    if (x < infinity) largest = std::max(largest, std::abs(x));
  for (const auto v : verts(found.mesh())) {
    const double x = found[v], y = expected[vert_at(m, found.mesh().global_number(v))];
    if (x != y) worst = std::max(worst, std::abs(x - y));
  }
  return worst / largest;
}

}  // namespace

TEST_CASE_TEMPLATE("distributed: heat geodesics equal those of one process", M, CONCINO_ALL_KINDS) {
  const M m = two_grids<M>(3);
  const unsigned last = static_cast<unsigned>(num_verts(m) - 1);
  const sources_of<M> all_sources[] = {{{vert_t<M>{1}, 0.0}}, {{vert_t<M>{2}, 0.25}, {vert_t<M>{7}, 0.0}, {vert_t<M>{last - 2}, 1.0}, {vert_t<M>{last}, 0.0}}};
  const vert_map<M, double> all_expected[] = {heat_geodesics(m, all_sources[0], {}, ldlt()), heat_geodesics(m, all_sources[1], {}, ldlt())};
  std::size_t k = 0;
  for (const auto& part : parts_of(m)) {
    const sources_of<M>& sources = all_sources[k % 2];
    const vert_map<M, double>& expected = all_expected[k % 2];
    ++k;
    const distributed<M> d(MPI_COMM_WORLD, is_first() ? m : M(), part);
    const auto own = own_sources(d, sources);
    CHECK(difference(m, heat_geodesics(d, own, {}, petsc({.preconditioner = petsc_preconditioner::mumps})), expected) < 1e-10);
    CHECK(difference(m, heat_geodesics(d, own), expected) < 1e-6);
  }
}

TEST_CASE("distributed: heat geodesics reach as far as the mesh, on ten thousand verts or a strip of one poly") {
  const quadmesh square = grid<quadmesh>(99);
  surface_arrays a{{}, {}, {}, 4};
  for (unsigned i = 0; i <= 1000; ++i) {
    for (const double y : {0.0, 1.0}) a.points.emplace_back(i, y, 0);
    if (i > 0)
      for (const unsigned v : {2 * i - 2, 2 * i, 2 * i + 1, 2 * i - 1}) a.verts.push_back(vert_id{v});
  }
  const quadmesh strip(a);
  for (const quadmesh* m : {&square, &strip}) {
    const sources_of<quadmesh> sources = {{vert_id{0}, 0.0}};
    const auto expected = heat_geodesics(*m, sources, {}, ldlt());
    const auto parts = parts_of(*m);
    const distributed<quadmesh> d(MPI_COMM_WORLD, is_first() ? *m : quadmesh(), parts[m == &square ? 0 : 3]);
    // the condition of Poisson's equation on the strip is about 1000^2
    const double tolerance = m == &square ? 1e-10 : 1e-9;
    CHECK(difference(*m, heat_geodesics(d, own_sources(d, sources), {}, petsc({.preconditioner = petsc_preconditioner::mumps})), expected) < tolerance);
    if (m == &strip) CHECK(difference(*m, heat_geodesics(d, own_sources(d, sources)), expected) < 1e-6);
  }
}

TEST_CASE("distributed: heat geodesics obey the options, and where heat is negative they equal those of one process") {
  auto arrays = hex_grid(8);
  for (vec3& x : arrays.points) x = {std::pow(x.x, 3), std::pow(x.y, 3), std::pow(x.z, 3)};
  const hexmesh thin(arrays);  // by positive weights; with Dirichlet conditions by paths along edges
  const hexmesh even = grid<hexmesh>(4);
  for (const hexmesh* m : {&thin, &even})
    for (const heat_geodesics_options& options :
         {heat_geodesics_options{}, {.boundary = heat_boundary::dirichlet}, {.time = 0.05, .boundary = heat_boundary::neumann}}) {
      const sources_of<hexmesh> sources = {{vert_id{0}, -1.5}, {vert_id{100}, -1.0}};
      const auto expected = heat_geodesics(*m, sources, options, ldlt());
      const auto parts = parts_of(*m);
      for (const std::size_t k : {0u, 1u}) {
        const distributed<hexmesh> d(MPI_COMM_WORLD, is_first() ? *m : hexmesh(), parts[k]);
        CHECK(difference(*m, heat_geodesics(d, own_sources(d, sources), options, petsc({.preconditioner = petsc_preconditioner::mumps})), expected) < 1e-10);
      }
    }
}

TEST_CASE("distributed: heat geodesics after a very short time equal those of one process") {
  const quadmesh m = grid<quadmesh>(6);
  const sources_of<quadmesh> sources = {{vert_id{0}, 0.0}, {vert_id{48}, 0.01}};
  const auto expected = heat_geodesics(m, sources, {.time = 1e-7}, ldlt());
  const distributed<quadmesh> d(MPI_COMM_WORLD, is_first() ? m : quadmesh(), parts_of(m)[0]);
  CHECK(difference(m, heat_geodesics(d, own_sources(d, sources), {.time = 1e-7}, petsc({.preconditioner = petsc_preconditioner::mumps})), expected) < 1e-10);
  CHECK(difference(m, heat_geodesics(d, own_sources(d, sources), {.time = 1e-7}), expected) < 1e-6);
}

TEST_CASE("distributed: heat geodesics of non-manifold meshes equal those of one process") {
  surface_arrays a{{}, {}, {}, 4};  // five sheets at one line
  constexpr unsigned n = 6;
  for (unsigned j = 0; j <= n; ++j) a.points.emplace_back(0, 0, j);
  for (unsigned sheet = 0; sheet < 5; ++sheet) {
    const double turn = 1.2 * sheet;
    const auto at = [&](unsigned i, unsigned j) { return vert_id{i == 0 ? j : (n + 1) * (1 + sheet * n + i - 1) + j}; };
    for (unsigned i = 1; i <= n; ++i)
      for (unsigned j = 0; j <= n; ++j) a.points.emplace_back(i * std::cos(turn), i * std::sin(turn), j);
    for (unsigned i = 0; i < n; ++i)
      for (unsigned j = 0; j < n; ++j) a.verts.insert(a.verts.end(), {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  }
  const quadmesh m(a);
  const sources_of<quadmesh> sources = {{vert_id{20}, 0.0}};
  const auto expected = heat_geodesics(m, sources, {}, ldlt());
  for (const auto& part : parts_of(m)) {
    const distributed<quadmesh> d(MPI_COMM_WORLD, is_first() ? m : quadmesh(), part);
    CHECK(difference(m, heat_geodesics(d, own_sources(d, sources), {}, petsc({.preconditioner = petsc_preconditioner::mumps})), expected) < 1e-10);
  }
}

TEST_CASE("distributed: heat geodesics of a closed surface equal those of one process") {
  const trimesh m = icosphere(3);
  const sources_of<trimesh> sources = {{vert_id{0}, 0.0}, {vert_id{300}, 0.5}};
  const auto expected = heat_geodesics(m, sources, {}, ldlt());
  for (const auto& part : parts_of(m)) {
    const distributed<trimesh> d(MPI_COMM_WORLD, is_first() ? m : trimesh(), part);
    CHECK(difference(m, heat_geodesics(d, own_sources(d, sources), {}, petsc({.preconditioner = petsc_preconditioner::mumps})), expected) < 1e-10);
    CHECK(difference(m, heat_geodesics(d, own_sources(d, sources), {}, petsc({.preconditioner = petsc_preconditioner::boomeramg, .tolerance = 1e-8})), expected) < 1e-6);
  }
}

TEST_CASE("distributed: sources may be verts, pairs or braces, of the process of a ghost alone, and count once") {
  const trimesh m = grid<trimesh>(5);
  distributed<trimesh> d(MPI_COMM_WORLD, is_first() ? m : trimesh(), parts_of(m)[1]);
  const distributed<trimesh>& constant = d;
  const auto expected = heat_geodesics(m, sources_of<trimesh>{{vert_id{14}, 0.0}}, {}, ldlt());
  const petsc solver({.preconditioner = petsc_preconditioner::mumps});
  std::vector<vert_id> own, of_ghosts;
  for (const vert_id v : verts(d))
    if (d.global_number(v) == 14) (d.is_ghost(v) ? of_ghosts : own).push_back(v);
  std::vector<vert_id> both = own;
  both.insert(both.end(), of_ghosts.begin(), of_ghosts.end());
  CHECK(difference(m, heat_geodesics(d, own, {}, solver), expected) < 1e-10);
  CHECK(difference(m, heat_geodesics(constant, both, {}, solver), expected) < 1e-10);
  if (number_of_processes() > 1) CHECK(difference(m, heat_geodesics(d, of_ghosts, {}, solver), expected) < 1e-10);
  if (number_of_processes() > 1) return;
  CHECK(difference(m, heat_geodesics(d, vert_id{14}, {}, solver), expected) < 1e-10);
  CHECK(difference(m, heat_geodesics(constant, {vert_id{14}, vert_id{14}}, {}, solver), expected) < 1e-10);
  CHECK(difference(m, heat_geodesics(d, {{vert_id{14}, 0.0}}, {}, solver), expected) < 1e-10);
}

TEST_CASE("distributed: what heat geodesics refuse is the same error on all processes") {
  trimesh m = two_grids<trimesh>(3);
  const auto parts = parts_of(m);
  {
    const distributed<trimesh> d(MPI_COMM_WORLD, is_first() ? m : trimesh(), parts[1]);
    using sources = sources_of<distributed<trimesh>>;
    CHECK_THROWS_WITH_AS(heat_geodesics(d, sources()), "heat_geodesics: there is no source; give at least one vert", invalid_argument);
    CHECK_THROWS_WITH_AS(heat_geodesics(d, sources(), {.time = -1}), doctest::Contains("heat_geodesics: time is -1"), invalid_argument);
    CHECK_THROWS_WITH_AS(heat_geodesics(d, sources(), {.clamp = true}), doctest::Contains("there is no clamp"), unsupported);
    sources wrong;
    for (const vert_id v : verts(d))
      if (d.global_number(v) == 5 && !d.is_ghost(v)) wrong.emplace_back(v, std::nan(""));
    CHECK_THROWS_WITH_AS(heat_geodesics(d, wrong), "heat_geodesics: the initial distance at vert 5 is not finite", invalid_argument);
    wrong.clear();
    if (rank() == number_of_processes() - 1) wrong.emplace_back(vert_id{1000}, 0.0);
    CHECK_THROWS_WITH_AS(heat_geodesics(d, wrong), "heat_geodesics: a source is not a vert of the mesh; take it from verts(m)", invalid_mesh);
    CHECK_THROWS_WITH_AS(heat_geodesics(d, own_sources(d, {{vert_id{0}, 0.0}}), {}, petsc({.max_iterations = 1})), doctest::Contains("not converged after 1 iterations"), solver_error);
  }
  const poly_id last{static_cast<unsigned>(num_polys(m) - 1)};
  vec3 corner;
  for (const vert_id v : adj_p2v(m, last)) corner = point(m, v);
  for (const vert_id v : adj_p2v(m, last)) set_point(m, v, corner);
  const distributed<trimesh> d(MPI_COMM_WORLD, is_first() ? m : trimesh(), parts[2]);
  CHECK_THROWS_WITH_AS(heat_geodesics(d, own_sources(d, {{vert_id{0}, 0.0}})), doctest::Contains("heat_geodesics: poly "), invalid_mesh);
}
