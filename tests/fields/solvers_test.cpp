// Every solver gives the same field, whether it reads one triangle of the matrix or both.
#include <concino/fields/harmonic_map.hpp>

#include <concino/fields/heat_geodesics.hpp>
#include <concino/mesh/tetmesh.hpp>
#include <concino/mesh/trimesh.hpp>
#include <concino/solve.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include <support/kinds.hpp>
#include <support/meshes.hpp>

using namespace concino;

TEST_CASE("harmonic_map: every solver gives the same result, also when reused") {
  const trimesh m(testing::triangle_grid(12));
  const vert_id a{0}, b{100};
  const auto expected = harmonic_map(m, {{a, 0.0}, {b, 1.0}});
  const auto check = [&](auto&& solver) {
    for (int again = 0; again < 2; ++again) {
      const auto u = harmonic_map(m, {{a, 0.0}, {b, 1.0}}, {}, solver);
      double worst = 0;
      for (const auto v : verts(m)) worst = std::max(worst, std::abs(u[v] - expected[v]));
      CHECK(worst < 1e-9);
    }
  };
  check(llt{});
  check(lu{});
  check(qr{});
  check(conjugate_gradients{});
  check(bicgstab{});
  check(multigrid{});
  check(auto_solver{});
  check(auto_solver{{.max_factor_entries = 0}});
}

TEST_CASE("problems report the solver that they used") {
  const trimesh m(testing::triangle_grid(12));
  auto_solver solver, small({.max_factor_entries = 10});
  harmonic_map(m, {{vert_id{0}, 0.0}, {vert_id{100}, 1.0}}, {}, solver);
  CHECK(solver.used() == solver_used::ldlt);
  harmonic_map(m, {{vert_id{0}, 0.0}, {vert_id{100}, 1.0}}, {}, small);
  CHECK(small.used() == solver_used::multigrid);
  CHECK(small.iterations() > 0);
  CHECK(small.iterations() < 60);
  CHECK(small.residual() <= 1e-12);
}

TEST_CASE("heat_geodesics: iteration gives the same distances, although small heat values are inaccurate") {
  const auto check = [](const auto& m, const auto& sources, double allowed) {
    const auto expected = heat_geodesics(m, sources);
    const auto d = heat_geodesics(m, sources, {}, auto_solver({.max_factor_entries = 0}));
    double worst = 0, most = 0;
    for (const auto v : verts(m)) {
      worst = std::max(worst, std::abs(d[v] - expected[v]));
      most = std::max(most, expected[v]);
    }
    CHECK(worst < allowed * most);
  };
  const trimesh square(testing::triangle_grid(30));
  check(square, vert_id{0}, 2e-3);
  check(square, std::vector<std::pair<vert_id, double>>{{vert_id{0}, 0.0}, {vert_id{30 * 31 + 30}, 1.2}}, 2e-3);  // there is far less heat at the other source
  check(tetmesh(testing::grid_arrays<tetmesh>(5)), vert_id{0}, 0.01);
  surface_arrays strip;
  strip.arity = 3;
  for (unsigned i = 0; i <= 200; ++i)
    for (unsigned j = 0; j <= 2; ++j) strip.points.push_back({static_cast<double>(i), static_cast<double>(j), 0});
  for (unsigned i = 0; i < 200; ++i)
    for (unsigned j = 0; j < 2; ++j)
      for (const unsigned k : {0u, 3u, 4u, 0u, 4u, 1u}) strip.verts.push_back(vert_id{3 * i + j + k});
  check(trimesh(strip), vert_id{0}, 1e-3);
}
