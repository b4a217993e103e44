#include <concino/operators/detail/virtual_elements.hpp>

#include <concino/geometry/centroid.hpp>
#include <concino/mesh/face_soup.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <Eigen/Dense>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M, class Element>
Eigen::MatrixXd matrix_of(const M&, Element element, const poly_t<M>& p) {
  detail::local_matrix<vert_t<M>> local;
  element(p, local);
  const auto n = static_cast<Eigen::Index>(local.size());
  Eigen::MatrixXd a(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j <= i; ++j) a(i, j) = a(j, i) = local.at(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
  return a;
}

template<class M, class F>
Eigen::VectorXd at_corners(const M& m, const poly_t<M>& p, const F& f) {
  Eigen::VectorXd u(64);
  Eigen::Index n = 0;
  for (const auto v : adj_p2v(m, p)) u[n++] = f(to_vec3(point(m, v)));
  return u.head(n);
}

const vec3 slope{2, -3, 0.5};

}  // namespace

TEST_CASE_TEMPLATE("stiffness of a poly: the energy of linear functions is exact, only constants have none", M, CONCINO_ALL_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.05, VolumeMesh<M>));
  const vec3 a = VolumeMesh<M> ? slope : vec3{2, -3, 0};
  for (const auto p : polys(m)) {
    const Eigen::MatrixXd k = matrix_of(m, detail::virtual_stiffness<M>(m), p);
    const auto u = at_corners(m, p, [&](const vec3& x) { return dot(a, x) + 7; });
    CHECK(u.dot(k * u) == doctest::Approx(dot(a, a) * measure(m, p)).epsilon(1e-12));
    const Eigen::VectorXd energies = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k, Eigen::EigenvaluesOnly).eigenvalues();
    CHECK(std::abs(energies[0]) < 1e-13);
    CHECK(energies[1] > 1e-3);
    // what is normal to linear functions has energy of the same order as they
    CHECK(energies[energies.size() - 1] < 60 * energies[1]);
  }
}

TEST_CASE("stiffness of a rectangle is that of the bilinear element, however long it is") {
  for (const double b : {1.0, 0.01, 300.0}) {
    const quadmesh m({{0, 0, 0}, {1, 0, 0}, {1, b, 0}, {0, b, 0}}, {{0, 1, 2, 3}});
    Eigen::Matrix4d along, across;  // integrals of u_x^2 and u_y^2
    along << 2, -2, -1, 1, -2, 2, 1, -1, -1, 1, 2, -2, 1, -1, -2, 2;
    across << 2, 1, -1, -2, 1, 2, -2, -1, -1, -2, 2, 1, -2, -1, 1, 2;
    const Eigen::Matrix4d expected = b / 6 * along + 1 / (6 * b) * across;
    CHECK((matrix_of(m, detail::virtual_stiffness<quadmesh>(m), poly_id{0}) - expected).norm() < 1e-14 * expected.norm());
  }
}

TEST_CASE("stiffness of a cube: products of two coordinates have the energy they have in the trilinear element") {
  const auto m = grid<hexmesh>(1);
  const Eigen::MatrixXd k = matrix_of(m, detail::virtual_stiffness<hexmesh>(m), poly_id{0});
  const auto u = at_corners(m, poly_id{0}, [](const vec3& x) { return (2 * x.x - 1) * (2 * x.y - 1); });
  CHECK(u.dot(k * u) == doctest::Approx(8.0 / 3).epsilon(1e-13));
}

TEST_CASE_TEMPLATE("stiffness and mass of a poly turned inside out are those of the poly", M, CONCINO_VOLUME_KINDS) {
  auto arrays = jittered(grid_arrays<M>(1), 0.1);
  const M m(arrays);
  for (vec3& x : arrays.points) x.x = -x.x;
  const M mirrored(arrays);
  for (const auto p : polys(m)) {
    CHECK(measure(mirrored, p) == doctest::Approx(-measure(m, p)));
    CHECK((matrix_of(m, detail::virtual_stiffness<M>(m), p) - matrix_of(mirrored, detail::virtual_stiffness<M>(mirrored), p)).norm() < 1e-14);
    CHECK((matrix_of(m, detail::virtual_mass<M>(m), p) - matrix_of(mirrored, detail::virtual_mass<M>(mirrored), p)).norm() < 1e-15);
  }
}

TEST_CASE_TEMPLATE("mass of a poly: first moments as the centroid says, positive definite", M, CONCINO_ALL_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.05, VolumeMesh<M>));
  for (const auto p : polys(m)) {
    const Eigen::MatrixXd mass = matrix_of(m, detail::virtual_mass<M>(m), p);
    const auto one = at_corners(m, p, [](const vec3&) { return 1.0; });
    const auto x = at_corners(m, p, [](const vec3& q) { return dot(slope, q); });
    CHECK(one.dot(mass * one) == doctest::Approx(measure(m, p)).epsilon(1e-12));
    CHECK(one.dot(mass * x) == doctest::Approx(measure(m, p) * dot(slope, centroid(m, p))).epsilon(1e-12));
    CHECK(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(mass, Eigen::EigenvaluesOnly).eigenvalues()[0] > 1e-3 * measure(m, p) / static_cast<double>(mass.rows()));
  }
}
