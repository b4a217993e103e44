#include <concino/operators/detail/virtual_elements.hpp>

#include <concino/geometry/centroid.hpp>
#include <concino/mesh/support/face_soup.hpp>

#include <support/kinds.hpp>
#include <support/motions.hpp>

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M, class Element>
Eigen::MatrixXd matrix_of(const M&, Element element, const poly_t<M>& p) {
  local_matrix<vert_t<M>> local;
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

TEST_CASE_TEMPLATE("stiffness: the energy of linear functions is exact, and 0 only for constants", M, CONCINO_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.05, VolumeMesh<M>));
  const vec3 a = VolumeMesh<M> ? slope : vec3{2, -3, 0};
  for (const auto p : polys(m)) {
    const Eigen::MatrixXd k = matrix_of(m, concino::detail::virtual_stiffness<M>(m), p);
    const auto u = at_corners(m, p, [&](const vec3& x) { return dot(a, x) + 7; });
    CHECK(u.dot(k * u) == doctest::Approx(dot(a, a) * measure(m, p)).epsilon(1e-12));
    const Eigen::VectorXd energies = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k, Eigen::EigenvaluesOnly).eigenvalues();
    CHECK(std::abs(energies[0]) < 1e-13);
    CHECK(energies[1] > 1e-3);
    // functions orthogonal to the linear ones have energies of the same order
    CHECK(energies[energies.size() - 1] < 60 * energies[1]);
  }
}

TEST_CASE("stiffness: of a rectangle equals that of the bilinear element, at any aspect ratio") {
  for (const double b : {1.0, 0.01, 300.0}) {
    const quadmesh m({{0, 0, 0}, {1, 0, 0}, {1, b, 0}, {0, b, 0}}, {{0, 1, 2, 3}});
    Eigen::Matrix4d along, across;  // integrals of u_x^2 and u_y^2
    along << 2, -2, -1, 1, -2, 2, 1, -1, -1, 1, 2, -2, 1, -1, -2, 2;
    across << 2, 1, -1, -2, 1, 2, -2, -1, -1, -2, 2, 1, -2, -1, 1, 2;
    const Eigen::Matrix4d expected = b / 6 * along + 1 / (6 * b) * across;
    CHECK((matrix_of(m, concino::detail::virtual_stiffness<quadmesh>(m), poly_id{0}) - expected).norm() < 1e-14 * expected.norm());
  }
}

TEST_CASE("stiffness: in a cube products of two coordinates have the energy of the trilinear element") {
  const auto m = grid<hexmesh>(1);
  const Eigen::MatrixXd k = matrix_of(m, concino::detail::virtual_stiffness<hexmesh>(m), poly_id{0});
  const auto u = at_corners(m, poly_id{0}, [](const vec3& x) { return (2 * x.x - 1) * (2 * x.y - 1); });
  CHECK(u.dot(k * u) == doctest::Approx(8.0 / 3).epsilon(1e-13));
}

TEST_CASE_TEMPLATE("stiffness of a polyhedron: the stabilisation has the scale of the smallest exact gradients", M, hexmesh, polyhedralmesh) {
  const M m(jittered(grid_arrays<M>(2), 0.1));
  corner_gradients<M> poly;
  double most = 0;
  for (const auto p : polys(m)) {
    poly.visit(m, p);
    const std::size_t n = poly.verts.size();
    Eigen::Matrix<double, 4, Eigen::Dynamic> seen(4, n);
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    Eigen::VectorXd u(n);
    double squares = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const auto c = static_cast<Eigen::Index>(i);
      const vec3 &g = poly.gradient[i], &y = poly.points[i];
      seen.col(c) << 1, g.x, g.y, g.z;
      const Eigen::Vector3d place(y.x, y.y, y.z);
      scatter += place * place.transpose();
      u[c] = std::sin(5.0 * static_cast<double>(i));
      squares += dot(g, g);
    }
    const Eigen::Matrix4d products = seen * seen.transpose();
    const Eigen::Vector4d linear = products.inverse() * (seen * u);
    u -= seen.transpose() * linear;
    const double least = scatter.inverse().trace(), factor = std::abs(measure(m, p)) * least * std::sqrt(static_cast<double>(n) / 162);
    CHECK(u.dot(matrix_of(m, concino::detail::virtual_stiffness<M>(m), p) * u) == doctest::Approx(factor * u.squaredNorm()).epsilon(1e-10));
    most = std::max(most, squares / least);
  }
  CHECK(most > 1.05);  // some polys are irregular
}

TEST_CASE("stiffness: energies are positive and accurate in nearly flat boxes") {
  Eigen::VectorXd alternating(8);
  alternating << 1, -1, 1, -1, -1, 1, -1, 1;
  for (const double height : {3e-8, 1e-8, 5e-9})
    for (int turn = 1; turn < 30; ++turn) {
      vec3 a{1, 0.1 * turn, 0.007 * turn * turn}, b = cross(a, {0.3, 1, 0.2 * turn});
      a /= norm(a);
      b /= norm(b);
      const vec3 c = height * cross(a, b);
      const hexmesh box({{}, a, a + b, b, c, a + c, a + b + c, b + c}, {{0, 1, 2, 3, 4, 5, 6, 7}});
      const Eigen::MatrixXd k = matrix_of(box, concino::detail::virtual_stiffness<hexmesh>(box), poly_id{0});
      const double energy = alternating.dot(k * alternating), squares = 1 + 0.5 / (height * height);
      CHECK(energy > 0);
      if (height > 6e-9) CHECK(energy < 1.05 * 8 * height * squares * std::sqrt(8.0 / 162));
    }
}

TEST_CASE_TEMPLATE("stiffness and mass: are the same for an inverted poly", M, CONCINO_VOLUME_KINDS) {
  auto arrays = jittered(grid_arrays<M>(1), 0.1);
  const M m(arrays);
  for (vec3& x : arrays.points) x.x = -x.x;
  const M mirrored(arrays);
  for (const auto p : polys(m)) {
    CHECK(measure(mirrored, p) == doctest::Approx(-measure(m, p)));
    CHECK((matrix_of(m, concino::detail::virtual_stiffness<M>(m), p) - matrix_of(mirrored, concino::detail::virtual_stiffness<M>(mirrored), p)).norm() < 1e-14);
    CHECK((matrix_of(m, concino::detail::virtual_mass<M>(m), p) - matrix_of(mirrored, concino::detail::virtual_mass<M>(mirrored), p)).norm() < 1e-15);
  }
}

TEST_CASE_TEMPLATE("mass: is positive definite, with first moments given by the centroid", M, CONCINO_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.05, VolumeMesh<M>));
  for (const auto p : polys(m)) {
    const Eigen::MatrixXd mass = matrix_of(m, concino::detail::virtual_mass<M>(m), p);
    const auto one = at_corners(m, p, [](const vec3&) { return 1.0; });
    const auto x = at_corners(m, p, [](const vec3& q) { return dot(slope, q); });
    CHECK(one.dot(mass * one) == doctest::Approx(measure(m, p)).epsilon(1e-12));
    CHECK(one.dot(mass * x) == doctest::Approx(measure(m, p) * dot(slope, centroid(m, p))).epsilon(1e-12));
    CHECK(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(mass, Eigen::EigenvaluesOnly).eigenvalues()[0] > 1e-3 * measure(m, p) / static_cast<double>(mass.rows()));
  }
}

namespace {

/// The smallest eigenvalue and the largest product with constants, relative to the largest eigenvalue.
struct rounding {
  double least, of_constants;
};
rounding rounding_of(const Eigen::MatrixXd& k) {
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k, Eigen::EigenvaluesOnly).eigenvalues();
  const double largest = values[values.size() - 1];
  return {values[0] / largest, (k * Eigen::VectorXd::Ones(k.cols())).cwiseAbs().maxCoeff() / largest};
}

}  // namespace

TEST_CASE_TEMPLATE("stiffness: energies are not negative up to rounding, however thin polys are", M, CONCINO_KINDS) {
  rounding worst{0, 0};
  for (const double jitter : {0.0, 0.08})
    for (const double thin : {1e-3, 1e-6, 1e-9, 1e-12})
      for (std::size_t along = 0; along < (SurfaceMesh<M> ? 2u : 3u); ++along) {
        auto arrays = grid_arrays<M>(2);
        if (jitter > 0) arrays = jittered(arrays, jitter, VolumeMesh<M>);
        for (vec3& x : arrays.points) x[along] *= thin;
        for (const bool turned : {false, true}) {
          const M m(turned ? rotated(arrays) : arrays);
          concino::detail::virtual_stiffness<M> stiffness(m);
          for (const auto p : polys(m)) {
            const rounding r = rounding_of(matrix_of(m, stiffness, p));
            worst.least = std::min(worst.least, r.least);
            worst.of_constants = std::max(worst.of_constants, r.of_constants);
          }
        }
      }
  CHECK(worst.least > -1e-14);
  CHECK(worst.of_constants < 1e-14);
}
