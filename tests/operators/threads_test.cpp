// Operators that run in parallel give the same bits for any number of threads.
#include <concino/operators/divergence.hpp>
#include <concino/operators/divergence_matrix.hpp>
#include <concino/operators/gradient.hpp>
#include <concino/operators/gradient_matrix.hpp>
#include <concino/operators/laplacian.hpp>
#include <concino/operators/mass_matrix.hpp>
#include <concino/operators/vert_gradient_matrix.hpp>

#include <support/fields.hpp>
#include <support/kinds.hpp>
#include <support/threads.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

namespace {

template<class F>
void with_threads(F&& f) {
  for (const int n : {1, 2, 5}) {
    const with_num_threads now(n);
    f();
  }
}

}  // namespace

TEST_CASE_TEMPLATE("operators: do not depend on the number of threads", M, trimesh, polygonmesh, tetmesh, polyhedralmesh) {
  const M m(jittered(grid_arrays<M>(VolumeMesh<M> ? 9 : 45), 0.1 / (VolumeMesh<M> ? 9 : 45)));
  const auto g = gradient_matrix(m), d = divergence_matrix(m), w = vert_gradient_matrix(m);
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = std::sin(5 * point(m, v).x) * point(m, v).y;
  const auto gu = gradient(m, u);
  const auto wu = vert_gradient(m, u);
  const auto du = divergence(m, gu);
  CHECK(num_polys(m) > 1024);
  with_threads([&] {
    CHECK(same_entries(gradient_matrix(m), g));
    CHECK(same_entries(divergence_matrix(m), d));
    CHECK(same_entries(vert_gradient_matrix(m), w));
    const auto same = [](const auto& a, const auto& b) { return std::equal(a.values().begin(), a.values().end(), b.values().begin()); };
    CHECK(same(gradient(m, u), gu));
    CHECK(same(vert_gradient(m, u), wu));
    CHECK(same(divergence(m, gu), du));
  });
}

TEST_CASE_TEMPLATE("Laplacians and masses: do not depend on the number of threads", M, trimesh, polygonmesh, tetmesh, polyhedralmesh) {
  const M m(jittered(grid_arrays<M>(VolumeMesh<M> ? 9 : 45), 0.1 / (VolumeMesh<M> ? 9 : 45)));
  const auto standard = laplacian(m), counted = laplacian(m, uniform), mass = mass_matrix(m, {.lumped = false});
  with_threads([&] {
    CHECK(same_entries(laplacian(m), standard));
    CHECK(same_entries(laplacian(m, uniform), counted));
    CHECK(same_entries(mass_matrix(m, {.lumped = false}), mass));
  });
}

TEST_CASE("operators: the error names the first poly without area, with any number of threads") {
  auto arrays = triangle_grid(50);
  for (const std::size_t p : {4000u, 1500u, 1501u, 2500u}) arrays.points[arrays.verts[3 * p].raw()] = arrays.points[arrays.verts[3 * p + 1].raw()];
  const trimesh m(arrays);
  std::string expected;
  for (const auto p : polys(m))
    if (expected.empty() && area(m, p) == 0) expected = "poly " + std::to_string(p.raw()) + " ";
  with_threads([&] { CHECK_THROWS_WITH_AS(gradient_matrix(m), doctest::Contains(expected.c_str()), invalid_mesh); });
}
