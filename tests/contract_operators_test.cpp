// One function body for all six kinds: measures, matrices, fields and the bounding tree.
#include <concino/fields.hpp>
#include <concino/geometry.hpp>
#include <concino/operators.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

namespace cn = concino;

TEST_CASE_TEMPLATE("one function body computes operators and fields on all six kinds", M, CONCINO_KINDS) {
  const M m = cn::testing::grid<M>(3);
  const cn::vert_t<M> b = *cn::verts(m).begin();
  const cn::poly_t<M> p = *cn::polys(m).begin();
  Eigen::SparseMatrix<double> L = cn::laplacian(m);
  Eigen::SparseMatrix<double> G = cn::gradient_matrix(m);
  Eigen::SparseMatrix<double> D = cn::divergence_matrix(m);
  Eigen::SparseMatrix<double> W = cn::mass_matrix(m);
  const auto V = static_cast<Eigen::Index>(cn::vert_index_bound(m)), P = static_cast<Eigen::Index>(cn::poly_index_bound(m));
  CHECK((L.rows() == V && L.cols() == V && G.rows() == 3 * P && G.cols() == V && D.rows() == V && D.cols() == 3 * P && W.rows() == V && W.nonZeros() == V));
  if constexpr (cn::TriMesh<M> || cn::TetMesh<M>) {
    Eigen::SparseMatrix<double> C = cn::laplacian(m, cn::cotangent);
    CHECK((L - C).norm() == 0);
  } else {
    if constexpr (cn::Discretisation<cn::cotangent_t, M>) CHECK_THROWS_AS(cn::laplacian(m, cn::cotangent), cn::unsupported);
  }

  double t = cn::total_measure(m);
  auto x = cn::centroid(m, p);
  if constexpr (cn::SurfaceMesh<M>) CHECK(cn::area(m, p) == cn::measure(m, p));
  else CHECK(cn::volume(m, p) == cn::measure(m, p));
  CHECK(W.sum() == doctest::Approx(t).epsilon(1e-12));

  auto f = cn::make_vert_map<double>(m, 1.0);
  auto u = cn::poisson(m, f, {.values = {{b, 0.0}}});
  auto g = cn::gradient(m, u);
  auto at_verts = cn::vert_gradient(m, u);
  CHECK(u[b] == 0);
  CHECK(cn::is_finite(g[p]));
  CHECK(cn::is_finite(at_verts[b]));

  auto tree = cn::bounding_tree(m);
  auto hit = tree.closest({x.x, x.y, x.z});
  auto q = tree.locate({x.x, x.y, x.z});
  CHECK(hit.distance == doctest::Approx(0));
  CHECK(q.has_value());
}
