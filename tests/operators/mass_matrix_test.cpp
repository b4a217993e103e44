#include <concino/operators/mass_matrix.hpp>

#include <concino/geometry/centroid.hpp>

#include <concino/concepts/archetypes.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <cmath>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("masses: sum to the measure, are positive on verts of polys and 0 on others", M, CONCINO_KINDS) {
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

TEST_CASE_TEMPLATE("masses: are the same on the archetype, and empty on an empty mesh", M, CONCINO_KINDS) {
  const M m = grid<M>(2);
  const auto g = only_embedded_mesh(m);
  const auto mass = vert_masses(m);
  const auto stripped = vert_masses(g);
  for (const auto v : verts(g)) CHECK(stripped[v] == doctest::Approx(mass[g.base(v)]).epsilon(1e-14));
  CHECK(mass_matrix(M()).rows() == 0);
}

TEST_CASE("masses: each poly gives equal parts of its absolute measure to its verts") {
  const polygonmesh m({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {2, 3, 0}}, {{0, 1, 2, 3}, {2, 4, 3}});
  const auto mass = vert_masses(m);
  CHECK(mass[vert_id{0}] == doctest::Approx(1));
  CHECK(mass[vert_id{2}] == doctest::Approx(1 + 1.0 / 3));
  CHECK(mass[vert_id{4}] == doctest::Approx(1.0 / 3));
  const tetmesh inverted({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1, 3}});
  for (const auto v : verts(inverted)) CHECK(vert_masses(inverted)[v] == doctest::Approx(1.0 / 24));
}

TEST_CASE_TEMPLATE("Galerkin mass: is the same for simplices by type and by virtual elements", M, trimesh, tetmesh) {
  const M m = two_grids<M>(2);
  const Eigen::SparseMatrix<double> mass = mass_matrix(m, {.lumped = false});
  const auto check = [&](const auto& g) {
    const Eigen::SparseMatrix<double> other = mass_matrix(g, {.lumped = false});
    CHECK(other.nonZeros() == mass.nonZeros());
    for (int c = 0; c < mass.cols(); ++c)
      for (Eigen::SparseMatrix<double>::InnerIterator it(mass, c); it; ++it)
        CHECK(other.coeff(it.row(), it.col()) == doctest::Approx(it.value()).epsilon(1e-13));
  };
  check(only_embedded_mesh(m));
  check(only_fixed_arity_mesh(m));
}

TEST_CASE_TEMPLATE("Galerkin mass: is positive definite, and integrates products of linear functions exactly", M, CONCINO_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.04, VolumeMesh<M>));
  const Eigen::SparseMatrix<double> mass = mass_matrix(m, {.lumped = false});
  const Eigen::MatrixXd dense = mass;
  CHECK(mass.isCompressed());
  CHECK(dense == dense.transpose());
  CHECK(dense.sum() == doctest::Approx(total_measure(m)).epsilon(1e-12));
  CHECK(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense, Eigen::EigenvaluesOnly).eigenvalues()[0] > 1e-5);
  // products of 1 and x, by the centroids
  Eigen::VectorXd one = Eigen::VectorXd::Ones(dense.rows()), x(dense.rows());
  for (const auto v : verts(m)) x[static_cast<Eigen::Index>(index_of(m, v))] = point(m, v)[0] + 2 * point(m, v)[1];
  double expected = 0;
  for (const auto p : polys(m)) expected += measure(m, p) * (centroid(m, p).x + 2 * centroid(m, p).y);
  CHECK(one.dot(dense * x) == doctest::Approx(expected).epsilon(1e-12));
}

TEST_CASE_TEMPLATE("Galerkin mass: integrates squares of linear functions over the unit square and cube", M, CONCINO_KINDS) {
  auto arrays = grid_arrays<M>(3);
  const auto moved = jittered(arrays, 0.03, VolumeMesh<M>);
  for (std::size_t i = 0; i < arrays.points.size(); ++i) {  // boundary verts do not move
    bool inside = true;
    for (std::size_t k = 0; k < (VolumeMesh<M> ? 3u : 2u); ++k) inside = inside && arrays.points[i][k] > 0.01 && arrays.points[i][k] < 0.99;
    if (inside) arrays.points[i] = moved.points[i];
  }
  const M m(arrays);
  const auto mass = mass_matrix(m, {.lumped = false});
  Eigen::VectorXd x(mass.rows()), y(mass.rows());
  for (const auto v : verts(m)) {
    x[static_cast<Eigen::Index>(index_of(m, v))] = point(m, v)[0];
    y[static_cast<Eigen::Index>(index_of(m, v))] = point(m, v)[1];
  }
  CHECK(x.dot(mass * x) == doctest::Approx(1.0 / 3).epsilon(1e-12));
  CHECK(x.dot(mass * y) == doctest::Approx(1.0 / 4).epsilon(1e-12));
}

TEST_CASE("Galerkin mass: equals that of linear elements on simplices, of bilinear ones on rectangles") {
  const trimesh t({{0, 0, 1}, {3, 1, 0}, {1, 2, 5}}, {{0, 1, 2}});
  const double a = area(t, poly_id{0});
  CHECK((Eigen::MatrixXd(mass_matrix(t, {.lumped = false})) - a / 12 * (Eigen::MatrixXd::Ones(3, 3) + Eigen::MatrixXd::Identity(3, 3))).norm() < 1e-13 * a);
  const tetmesh k({{0, 0, 1}, {3, 1, 0}, {1, 2, 5}, {4, 4, 4}}, {{0, 2, 1, 3}});
  const double c = std::abs(volume(k, poly_id{0}));
  CHECK((Eigen::MatrixXd(mass_matrix(k, {.lumped = false})) - c / 20 * (Eigen::MatrixXd::Ones(4, 4) + Eigen::MatrixXd::Identity(4, 4))).norm() < 1e-13 * c);
  const quadmesh q({{0, 0, 0}, {3, 0, 0}, {3, 0.5, 0}, {0, 0.5, 0}}, {{0, 1, 2, 3}});
  Eigen::Matrix4d bilinear;
  bilinear << 4, 2, 1, 2, 2, 4, 2, 1, 1, 2, 4, 2, 2, 1, 2, 4;
  CHECK((Eigen::Matrix4d(mass_matrix(q, {.lumped = false})) - 1.5 / 36 * bilinear).norm() < 1e-14);
}

TEST_CASE_TEMPLATE("masses: points that are not finite throw; polys without measure have no Galerkin mass", M, CONCINO_KINDS) {
  auto arrays = grid_arrays<M>(1);
  auto flat = arrays;
  for (vec3& x : flat.points) x.y = x.z = 0;
  CHECK(mass_matrix(M(flat)).sum() == 0);
  CHECK_THROWS_WITH_AS(mass_matrix(M(flat), {.lumped = false}), doctest::Contains("mass matrix: poly 0"), invalid_mesh);
  M m(arrays);
  const double bad[3] = {std::nan(""), 0, 0};
  set_point(m, vert_id{0}, bad);
  CHECK_THROWS_WITH_AS(vert_masses(m), doctest::Contains("masses: poly 0"), invalid_mesh);
  CHECK_THROWS_WITH_AS(mass_matrix(m, {.lumped = false}), doctest::Contains("mass matrix: poly 0"), invalid_mesh);
}
