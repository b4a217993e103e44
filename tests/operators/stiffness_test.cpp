#include <concino/operators/stiffness.hpp>

#include <concino/operators/laplacian.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <Eigen/Core>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("lower_stiffness: is the lower triangle of minus the Laplacian", M, CONCINO_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.03));
  const auto check = [&](const auto& which) {
    const Eigen::MatrixXd lower = lower_stiffness(m, which), l = laplacian(m, which);
    for (Eigen::Index i = 0; i < l.rows(); ++i)
      for (Eigen::Index j = 0; j < l.cols(); ++j) CHECK(lower(i, j) == doctest::Approx(j <= i ? -l(i, j) : 0).epsilon(1e-12).scale(1));
  };
  check(uniform);
  check(virtual_elements);
}

TEST_CASE("with_stiffness: passes the weights of edges, or an element for each thread") {
  const auto triangles = grid<trimesh>(1);
  const auto quads = grid<quadmesh>(1);
  int by_weights = 0, by_polys = 0;
  const auto ask = [&](const auto& m) {
    with_stiffness(
        m, virtual_elements,
        [&](const auto& w) {
          for (const auto v : verts(m)) {
            int n = 0;
            w.for_each_neighbour(v, [&](const auto&, double) { ++n; });
            CHECK(n == w.num_neighbours(v));
          }
          ++by_weights;
          return Eigen::SparseMatrix<double>();
        },
        [&](const auto& make) {
          CHECK(make() != make());
          ++by_polys;
          return Eigen::SparseMatrix<double>();
        });
  };
  ask(triangles);
  ask(quads);
  CHECK(by_weights == 1);
  CHECK(by_polys == 1);
}
