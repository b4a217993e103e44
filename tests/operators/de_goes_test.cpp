#include <concino/operators/de_goes.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/operators/laplacian.hpp>

#include <support/kinds.hpp>
#include <support/stiffness.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M> Eigen::MatrixXd matrix_of(const M& m) { return stiffness<concino::detail::de_goes_element<M>>(m); }

}  // namespace

TEST_CASE("de Goes: equals the cotangent Laplacian on triangles") {
  const trimesh m(jittered(triangle_grid(3), 0.05));
  const Eigen::MatrixXd expected = laplacian(m, cotangent);
  CHECK((matrix_of(m) + expected).cwiseAbs().maxCoeff() < 1e-13);
  CHECK((matrix_of(polygonmesh(with_offsets(jittered(triangle_grid(3), 0.05)))) + expected).cwiseAbs().maxCoeff() < 1e-13);
}

TEST_CASE_TEMPLATE("de Goes: is semidefinite with constants as kernel, and linear functions are harmonic", M, CONCINO_SURFACE_KINDS) {
  const M m(jittered(grid_arrays<M>(3), 0.04, false));
  const Eigen::MatrixXd k = matrix_of(m);
  CHECK(k.rowwise().sum().cwiseAbs().maxCoeff() < 1e-13);
  CHECK(residual_of_coordinates(m, k) < 1e-13);
  const auto values = spectrum(k);
  CHECK(std::abs(values[0]) < 1e-13);
  CHECK(values[1] > 1e-3);
  Eigen::VectorXd y(k.rows());
  for (const auto v : verts(m)) y[static_cast<Eigen::Index>(index_of(m, v))] = to_vec3(point(m, v)).y;
  CHECK(y.dot(k * y) == doctest::Approx(total_measure(m)).epsilon(1e-12));
}

TEST_CASE_TEMPLATE("de Goes: is semidefinite on non-planar polygons, scales exactly, the same on the archetype", M, CONCINO_SURFACE_KINDS) {
  auto arrays = jittered(grid_arrays<M>(3), 0.1);
  const M m(arrays);
  const Eigen::MatrixXd k = matrix_of(m);
  const auto values = spectrum(k);
  CHECK(std::abs(values[0]) < 1e-13);
  CHECK(values[1] > 1e-3);
  const auto stripped = only_embedded_mesh(m);
  const Eigen::MatrixXd same = matrix_of(stripped);
  CHECK(same.trace() == doctest::Approx(k.trace()).epsilon(1e-12));
  CHECK(same.squaredNorm() == doctest::Approx(k.squaredNorm()).epsilon(1e-12));
  for (vec3& x : arrays.points) x *= 1048576;
  CHECK(matrix_of(M(arrays)) == k);
  for (vec3& x : arrays.points) x = x / 1048576 + vec3{1024, -512, 2048};
  CHECK((matrix_of(M(arrays)) - k).cwiseAbs().maxCoeff() < 1e-9);
}

TEST_CASE("de Goes: is right on the unit square and on a polygon that is not star-shaped") {
  const Eigen::MatrixXd square = matrix_of(grid<quadmesh>(1));
  const auto& row = square.row(0);  // with verts 0 1 / 2 3; all differences of the alternating function have energy
  CHECK(row[0] == doctest::Approx(1.5));
  CHECK(row[1] == doctest::Approx(-1));
  CHECK(row[2] == doctest::Approx(-1));
  CHECK(row[3] == doctest::Approx(0.5));
  const polygonmesh c({{0, 0, 0}, {6, 0, 0}, {6, 1, 0}, {1, 1, 0}, {1, 5, 0}, {6, 5, 0}, {6, 6, 0}, {0, 6, 0}}, {{0, 1, 2, 3, 4, 5, 6, 7}});
  const auto values = spectrum(matrix_of(c));
  CHECK(std::abs(values[0]) < 1e-12);
  CHECK(values[1] > 1e-3);
}

TEST_CASE("de Goes: works on a user's mesh") {
  const auto values = spectrum(matrix_of(user_mesh::surface_example()));
  CHECK(std::abs(values[1]) < 1e-13);  // constants on the mesh, and on the isolated vert
  CHECK(values[2] > 1e-3);
}

TEST_CASE_TEMPLATE("de Goes: throws for polys without area and points that are not finite", M, CONCINO_SURFACE_KINDS) {
  auto arrays = grid_arrays<M>(2);
  arrays.points[1].x = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(matrix_of(M(arrays)), invalid_mesh);
  for (vec3& x : arrays.points) x = {x.y, x.y, x.y};
  CHECK_THROWS_AS(matrix_of(M(arrays)), invalid_mesh);
}
