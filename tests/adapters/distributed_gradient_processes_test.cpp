// Gradients on distributed meshes equal those of one process, on any partition. Every test also passes on one process.
#include <concino/adapters/distributed.hpp>
#include <concino/adapters/distributed_gradient.hpp>

#include <concino/geometry/measure.hpp>
#include <concino/operators/gradient.hpp>

#include <support/distributed.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

using namespace concino;
using namespace concino::testing;
using namespace distributed_tests;

TEST_CASE_TEMPLATE("distributed: gradients equal those of one process", M, CONCINO_ALL_KINDS) {
  const M m = two_grids<M>(3);
  auto u = make_vert_map<double>(m, 0.0);
  for (const auto v : verts(m)) u[v] = std::sin(static_cast<double>(index_of(m, v)));
  const auto at_polys = gradient(m, u);
  const auto at_verts = vert_gradient(m, u);
  double largest = 0;
  for (const auto p : polys(m)) largest = std::max(largest, norm(at_polys[p]));
  for (const auto& part : parts_of(m)) {
    distributed<M> d(MPI_COMM_WORLD, is_first() ? m : M(), part);
    const distributed<M>& constant = d;
    auto x = make_vert_map<double>(d, 0.0);
    for (const auto v : verts(d)) x[v] = d.is_ghost(v) ? std::numeric_limits<double>::quiet_NaN() : u[vert_at(m, d.global_number(v))];
    double worst = 0;
    for (const auto& g : {gradient(d, x), gradient(constant, x)})
      for (const auto p : polys(d)) worst = std::max(worst, norm(g[p] - at_polys[poly_at(m, d.global_number(p))]));
    for (const auto& g : {vert_gradient(d, x), vert_gradient(constant, x)})
      for (const auto v : verts(d)) worst = std::max(worst, norm(g[v] - at_verts[vert_at(m, d.global_number(v))]));
    CHECK(worst <= 1e-12 * largest);
  }
}

TEST_CASE("distributed: a poly without area is the same error of its gradient on all processes") {
  trimesh m = two_grids<trimesh>(3);
  for (const vert_id v : adj_p2v(m, poly_id{7})) set_point(m, v, vec3(0, 0, 0));
  const distributed<trimesh> d(MPI_COMM_WORLD, is_first() ? m : trimesh(), parts_of(m)[1]);
  const auto u = make_vert_map<double>(d, 1.0);
  std::string said;
  try {
    gradient(d, u);
  } catch (const invalid_mesh& e) {
    said = e.what();
  }
  bool is_named = false;  // by its number in the whole mesh
  for (const poly_id p : polys(m)) is_named |= measure(m, p) == 0 && said.starts_with("gradient: poly " + std::to_string(p.raw()) + " has no area");
  CHECK_MESSAGE(is_named, said);
  CHECK_THROWS_WITH_AS(vert_gradient(d, u), doctest::Contains(" has no area"), invalid_mesh);
}
