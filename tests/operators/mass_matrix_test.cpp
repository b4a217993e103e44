#include <concino/operators/mass_matrix.hpp>

#include <concino/concepts/archetypes.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("masses sum to the measure, are positive on verts of polys and 0 on others", M, CONCINO_ALL_KINDS) {
  auto arrays = two_grids_arrays<M>(3);
  for (vec3& x : arrays.points) x.x *= 1 + x.x / 8;
  const M m(arrays);
  const auto mass = vert_masses(m);
  double sum = 0;
  for (const auto v : verts(m)) {
    const auto around = adj_v2p(m, v);
    CHECK((mass[v] > 0) == (around.begin() != around.end()));
    sum += mass[v];
  }
  CHECK(sum == doctest::Approx(total_measure(m)).epsilon(1e-13));
  const auto matrix = mass_matrix(m);
  CHECK(static_cast<std::size_t>(matrix.rows()) == vert_index_bound(m));
  CHECK(matrix.nonZeros() == matrix.rows());
  for (const auto v : verts(m)) CHECK(matrix.coeff(static_cast<int>(index_of(m, v)), static_cast<int>(index_of(m, v))) == mass[v]);
}

TEST_CASE_TEMPLATE("masses: the same on the archetype; nothing on an empty mesh", M, CONCINO_ALL_KINDS) {
  const M m = grid<M>(2);
  const auto g = only_embedded_mesh(m);
  const auto mass = vert_masses(m);
  const auto stripped = vert_masses(g);
  for (const auto v : verts(g)) CHECK(stripped[v] == doctest::Approx(mass[g.base(v)]).epsilon(1e-14));
  CHECK(mass_matrix(M()).rows() == 0);
}

TEST_CASE("masses: equal parts to the verts of each poly, by absolute volume") {
  const polygonmesh m({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {2, 3, 0}}, {{0, 1, 2, 3}, {2, 4, 3}});
  const auto mass = vert_masses(m);
  CHECK(mass[vert_id{0}] == doctest::Approx(1));
  CHECK(mass[vert_id{2}] == doctest::Approx(1 + 1.0 / 3));
  CHECK(mass[vert_id{4}] == doctest::Approx(1.0 / 3));
  const tetmesh inverted({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1, 3}});
  for (const auto v : verts(inverted)) CHECK(vert_masses(inverted)[v] == doctest::Approx(1.0 / 24));
}
