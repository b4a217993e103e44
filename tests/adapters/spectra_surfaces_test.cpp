// Eigenfunctions of surfaces of every kind.
#include <concino/adapters/spectra.hpp>

#include <support/eigenfunctions.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/solve/ldlt.hpp>

#include <limits>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr auto by_spectra = [](const auto& m, std::size_t count) { return eigenfunctions(m, count); };

}  // namespace

TEST_CASE_TEMPLATE("eigenfunctions: are right on the square, spheres and two squares, and scale exactly", M, CONCINO_SURFACE_KINDS) {
  const double coarse = error_on_square_or_cube<M>(6, by_spectra), fine = error_on_square_or_cube<M>(12, by_spectra);
  CHECK(fine < 0.4 * coarse);
  CHECK(fine < 0.03);
  const M sphere = make_sphere<M>({.cells = 6});
  check_sphere(sphere, {2, 6}, 0.08, by_spectra);  // l (l + 1)
  check_components<M>(3, by_spectra);
  check_scaling<M>(3, by_spectra);
}

TEST_CASE("eigenfunctions: symmetric spheres have multiple eigenvalues to the last digits") {
  const trimesh m = icosphere(2);
  check_sphere(m, {2, 6}, 0.03, by_spectra);
  const auto r = eigenfunctions(m, 9);
  for (const std::size_t k : {2u, 3u}) CHECK(r.values[k] == doctest::Approx(r.values[1]).epsilon(1e-11));
  for (const std::size_t k : {5u, 6u, 7u, 8u}) CHECK(r.values[k] == doctest::Approx(r.values[4]).epsilon(1e-11));
  CHECK(eigenfunctions(m, 6).values[5] == doctest::Approx(r.values[4]).epsilon(1e-11));  // the number divides a group of equal eigenvalues
}

TEST_CASE("eigenfunctions: run on archetypes, obey options, and throw errors") {
  const auto m = grid<trimesh>(8);
  const auto weak = only_embedded_mesh(m);
  const auto plain = eigenfunctions(m, 4);
  const auto by_archetype = eigenfunctions(weak, 4);
  for (std::size_t k = 0; k < 4; ++k) CHECK(by_archetype.values[k] == doctest::Approx(plain.values[k]).epsilon(1e-9));
  CHECK(eigenfunctions(m, 3, cotangent).values[1] == doctest::Approx(plain.values[1]));
  CHECK(eigenfunctions(m, 3, {.lumped = false}).values[1] > std::numbers::pi * std::numbers::pi);  // an approximation from above
  ldlt solver;
  CHECK(eigenfunctions(m, 3, {.tolerance = 1e-6}, solver).values[2] == doctest::Approx(plain.values[2]));
  CHECK_THROWS_AS(eigenfunctions(m, 0), invalid_argument);
  CHECK_THROWS_AS(eigenfunctions(m, 82), invalid_argument);
  CHECK_THROWS_AS(eigenfunctions(m, 20, {.max_restarts = 0}), invalid_argument);
  const polygonmesh quads({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
  CHECK_THROWS_AS(eigenfunctions(quads, 2, cotangent), unsupported);
  const trimesh endless({{0, 0, 0}, {1, 0, 0}, {0, std::numeric_limits<double>::infinity(), 0}}, {{0, 1, 2}});
  CHECK_THROWS_AS(eigenfunctions(endless, 1), invalid_mesh);
  const trimesh nothing;
  CHECK_THROWS_AS(eigenfunctions(nothing, 1), invalid_argument);
}
