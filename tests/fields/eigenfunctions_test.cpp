#include <concino/fields/eigenfunctions.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/generate/random_points.hpp>
#include <concino/generate/torus.hpp>
#include <concino/generate/voronoi_polyhedra.hpp>

#include <support/eigenfunctions.hpp>
#include <support/threads.hpp>

#include <limits>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr auto by_lobpcg = [](const auto& m, std::size_t count) {
  auto r = eigenfunctions(m, count, lobpcg, {.tolerance = 1e-11});
  CHECK(r.has_converged);
  CHECK(r.iterations > 0);
  return r;
};

}  // namespace

TEST_CASE_TEMPLATE("eigenfunctions by LOBPCG: are right on the square or cube, on spheres or balls and on components, and scale exactly", M, CONCINO_ALL_KINDS) {
  const unsigned n = dimension_v<M> == 2 ? 16 : 6;
  const double coarse = error_on_square_or_cube<M>(n, by_lobpcg), fine = error_on_square_or_cube<M>(2 * n, by_lobpcg);
  CHECK(fine < 0.4 * coarse);
  CHECK(fine < 0.03);
  if constexpr (dimension_v<M> == 2) check_sphere(make_sphere<M>({.cells = 12}), {2, 6}, 0.03, by_lobpcg);  // l (l + 1)
  else check_sphere(make_sphere<M>({.cells = 8}), {4.333, 11.17}, 0.06, by_lobpcg);  // squares of the zeros of derivatives of spherical Bessel functions
  check_components<M>(dimension_v<M> == 2 ? 12 : 5, by_lobpcg);
  check_scaling<M>(n, by_lobpcg);
}

TEST_CASE("eigenfunctions by LOBPCG: symmetric shapes have multiple eigenvalues") {
  const trimesh sphere = icosphere(3);
  check_sphere(sphere, {2, 6}, 0.01, by_lobpcg);
  const auto r = by_lobpcg(sphere, 9);
  for (const std::size_t k : {2u, 3u}) CHECK(r.values[k] == doctest::Approx(r.values[1]).epsilon(1e-11));
  for (const std::size_t k : {5u, 6u, 7u, 8u}) CHECK(r.values[k] == doctest::Approx(r.values[4]).epsilon(1e-11));
  for (const std::size_t cut : {3u, 6u}) CHECK(by_lobpcg(sphere, cut).values[cut - 1] == doctest::Approx(r.values[cut - 1]).epsilon(1e-11));  // within a group
  const auto torus = by_lobpcg(make_torus<quadmesh>({}), 5).values;
  CHECK(torus[1] == doctest::Approx(torus[2]).epsilon(1e-11));
  CHECK(torus[3] == doctest::Approx(torus[4]).epsilon(1e-11));
  CHECK(torus[3] > 1.5 * torus[1]);
}

TEST_CASE("eigenfunctions by LOBPCG: of Voronoi polyhedra, for lumped and Galerkin masses, and any number of threads") {
  const box domain{{0, 0, 0}, {3, 2, 1.2}};
  const auto m = voronoi_polyhedra(random_points(100, domain), domain);
  const double pi2 = std::numbers::pi * std::numbers::pi;
  for (const bool lumped : {true, false}) {
    const auto r = eigenfunctions(m, 5, lobpcg, {.lumped = lumped});
    const std::vector<double> known{0, pi2 / 9, pi2 / 4, pi2 / 9 + pi2 / 4, 4 * pi2 / 9};
    for (std::size_t k = 0; k < 5; ++k) CHECK(std::abs(r.values[k] - known[k]) < 0.12 * known[k] + 1e-10);
    for (std::size_t k = 1; k < 5 && !lumped; ++k) CHECK(r.values[k] > known[k]);
    for (const int threads : {1, 3}) {
      const with_num_threads set(threads);
      const auto again = eigenfunctions(m, 5, lobpcg, {.lumped = lumped});
      CHECK(again.values == r.values);
      for (std::size_t k = 0; k < 5; ++k)
        for (const auto v : verts(m)) REQUIRE(again.functions[k][v] == r.functions[k][v]);
    }
  }
}

TEST_CASE("eigenfunctions by LOBPCG: run on archetypes, with discretisations and options, and throw errors") {
  const auto m = grid<trimesh>(16);
  const auto weak = only_embedded_mesh(m);
  const auto plain = by_lobpcg(m, 4);
  const auto by_archetype = by_lobpcg(weak, 4);
  for (std::size_t k = 0; k < 4; ++k) CHECK(by_archetype.values[k] == doctest::Approx(plain.values[k]).epsilon(1e-9));
  CHECK(eigenfunctions(m, 3, cotangent, lobpcg).values[1] == doctest::Approx(plain.values[1]));
  CHECK(eigenfunctions(m, 3, uniform, lobpcg).values[1] > 0);
  CHECK(eigenfunctions(m, 3, lobpcg, {.lumped = false}).values[1] > std::numbers::pi * std::numbers::pi);  // an approximation from above
  int calls = 0;
  const auto count = [&](double, const char*) { return ++calls > 0; };
  eigenfunctions(m, 3, lobpcg, {.progress = count});
  CHECK(calls > 3);
  const auto refuse = [](double, const char*) { return false; };
  CHECK_THROWS_AS(eigenfunctions(m, 3, lobpcg, {.progress = refuse}), cancelled);
  const auto few = eigenfunctions(m, 3, lobpcg, {.max_iterations = 2, .accept_missed_tolerance = true});
  CHECK_FALSE(few.has_converged);
  CHECK(few.iterations == 2);
  CHECK_THROWS_AS(eigenfunctions(m, 3, lobpcg, {.max_iterations = 2}), solver_error);
  CHECK_THROWS_AS(eigenfunctions(m, 3, lobpcg, {.tolerance = 0}), invalid_argument);
  CHECK_THROWS_AS(eigenfunctions(m, 0, lobpcg), invalid_argument);
  CHECK_THROWS_AS(eigenfunctions(m, 290, lobpcg), invalid_argument);
  CHECK(eigenfunctions(m, 289, lobpcg).values.size() == 289);  // by the dense solver
  const polygonmesh quads({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
  CHECK_THROWS_AS(eigenfunctions(quads, 2, cotangent, lobpcg), unsupported);
  CHECK(eigenfunctions(quads, 4, lobpcg).values[1] > 0);
  const trimesh endless({{0, 0, 0}, {1, 0, 0}, {0, std::numeric_limits<double>::infinity(), 0}}, {{0, 1, 2}});
  CHECK_THROWS_AS(eigenfunctions(endless, 1, lobpcg), invalid_mesh);
  const trimesh nothing;
  CHECK_THROWS_AS(eigenfunctions(nothing, 1, lobpcg), invalid_argument);
}
