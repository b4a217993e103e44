// The Laplacian of a sphere from the corpus: its lowest eigenvalues and its mean curvature agree with results without a mesh library.
#include <concino/operators/laplacian.hpp>
#include <concino/operators/mass_matrix.hpp>
#include <concino/solve/ldlt.hpp>

#include <concino/io/load.hpp>
#include <concino/mesh/trimesh.hpp>

#include <support/corpus.hpp>

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <vector>

using namespace concino;
using namespace concino::testing;

TEST_CASE("corpus: eigenvalues and mean curvature of a sphere are the known ones") {
  const auto file = corpus("tri/sphere.obj");
  if (file.empty()) return skip("no corpus");
  const auto m = load<trimesh>(file);
  const auto n = static_cast<Eigen::Index>(vert_index_bound(m));
  const Eigen::SparseMatrix<double> l = laplacian(m);
  const Eigen::VectorXd mass = mass_matrix(m).diagonal();

  Eigen::MatrixXd x(n, 3);
  for (const auto v : verts(m))
    for (Eigen::Index k = 0; k < 3; ++k) x(static_cast<Eigen::Index>(index_of(m, v)), k) = point(m, v)[static_cast<std::size_t>(k)];
  const Eigen::MatrixXd bent = l * x;
  const Eigen::VectorXd curvature = bent.rowwise().norm().cwiseQuotient(2 * mass);
  CHECK(mass.sum() == doctest::Approx(3.13293354753).epsilon(1e-11));
  CHECK(curvature.mean() == doctest::Approx(2.0165755623).epsilon(1e-9));
  CHECK(curvature.minCoeff() == doctest::Approx(0.248478134992).epsilon(1e-8));
  CHECK(curvature.maxCoeff() == doctest::Approx(7.03603419647).epsilon(1e-9));

  // Inverse iteration of nine functions that are close to the eigenfunctions: 1, the coordinates and their products.
  Eigen::MatrixXd u(n, 9);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double a = x(i, 0), b = x(i, 1), c = x(i, 2);
    u.row(i) << 1, a, b, c, a * b, b * c, c * a, a * a - b * b, 2 * c * c - a * a - b * b;
  }
  Eigen::SparseMatrix<double> shifted = -l;
  shifted.diagonal() += mass;
  ldlt solver;
  solver.factorize(shifted);
  Eigen::VectorXd values;
  for (int round = 0; round < 8; ++round) {
    Eigen::MatrixXd next(n, 9);
    for (Eigen::Index k = 0; k < 9; ++k) next.col(k) = solver.solve(mass.cwiseProduct(u.col(k)));
    const Eigen::MatrixXd stiffness = next.transpose() * (-l * next).eval(), masses = next.transpose() * mass.asDiagonal() * next;
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> small(stiffness, masses);
    values = small.eigenvalues();
    u = next * small.eigenvectors();
  }
  const double expected[] = {8.01911776, 8.01915962, 8.01918382, 24.046407, 24.0467518, 24.0470199, 24.0472089, 24.0472456};
  CHECK(std::abs(values[0]) < 1e-9);
  for (Eigen::Index k = 0; k < 8; ++k) CHECK(values[k + 1] == doctest::Approx(expected[k]).epsilon(3e-9));
}
