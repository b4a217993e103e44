#include <concino/operators/poly_mass_matrix.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/edit.hpp>

#include <support/fields.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <numeric>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("poly_masses: sum to the measure; the matrix has each three times, without deleted polys", M, CONCINO_KINDS) {
  M m(jittered(two_grids_arrays<M>(2), 0.05));
  remove_poly(m, poly_id{1});
  const auto mass = poly_masses(m);
  const auto matrix = poly_mass_matrix(m);
  check_compressed(matrix);
  CHECK(static_cast<std::size_t>(matrix.rows()) == 3 * poly_index_bound(m));
  CHECK(matrix.cols() == matrix.rows());
  CHECK(static_cast<std::size_t>(matrix.nonZeros()) == 3 * num_polys(m));
  double sum = 0;
  for (const auto p : polys(m)) {
    sum += mass[p];
    for (int k = 0; k < 3; ++k) CHECK(matrix.coeff(3 * static_cast<int>(p.raw()) + k, 3 * static_cast<int>(p.raw()) + k) == mass[p]);
  }
  CHECK(sum == doctest::Approx(total_measure(m)).epsilon(1e-13));
  CHECK(std::accumulate(mass.values().begin(), mass.values().end(), 0.0) == sum);  // deleted polys have mass 0
  const auto g = only_embedded_mesh(m);
  const auto stripped = poly_masses(g);
  for (const auto p : polys(g)) CHECK(stripped[p] == doctest::Approx(mass[g.base(p)]).epsilon(1e-14));
  CHECK(poly_mass_matrix(M()).size() == 0);
}

TEST_CASE("poly_masses: are positive for inverted polys, 0 for degenerate ones, an error for NaN") {
  tetmesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}}, {{0, 2, 1, 3}, {0, 1, 2, 4}});
  CHECK(poly_masses(m)[poly_id{0}] == doctest::Approx(1.0 / 6));
  CHECK(poly_masses(m)[poly_id{1}] == 0);
  CHECK(poly_mass_matrix(m).nonZeros() == 6);
  set_point(m, vert_id{4}, vec3{std::nan(""), 0, 0});
  CHECK_THROWS_WITH_AS(poly_masses(m), "poly_masses: the volume of poly 1 is not a finite number; look at the points of its verts", invalid_mesh);
  const trimesh endless({{0, 0, 0}, {HUGE_VAL, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  CHECK_THROWS_WITH_AS(poly_masses(endless), doctest::Contains("poly_masses: the area of poly 0"), invalid_mesh);
  CHECK_THROWS_WITH_AS(poly_mass_matrix(m), doctest::Contains("poly_mass_matrix: the volume of poly 1"), invalid_mesh);
}
