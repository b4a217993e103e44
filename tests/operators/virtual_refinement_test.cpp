#include <concino/operators/detail/virtual_refinement.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/operators/laplacian.hpp>

#include <support/kinds.hpp>
#include <support/stiffness.hpp>
#include <support/tiny.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M> Eigen::MatrixXd refined(const M& m) { return stiffness<concino::detail::virtual_refinement_element<M>>(m); }

/// A grid whose verts inside are pushed about, in the plane or in space.
template<class M> M pushed_grid(unsigned n) {
  auto arrays = grid_arrays<M>(n);
  const auto moved = jittered(arrays, 0.06 / n, dimension_v<M> == 3);
  const auto inside = [](double x) { return x > 0 && x < 1; };
  for (std::size_t i = 0; i < arrays.points.size(); ++i) {
    const vec3 x = arrays.points[i];
    if (inside(x.x) && inside(x.y) && (dimension_v<M> == 2 || inside(x.z))) arrays.points[i] = moved.points[i];
  }
  return M(arrays);
}

/// A C of 8 verts: no point of it sees both arms.
surface_arrays letter_c() {
  surface_arrays s{{{0, 0, 0}, {6, 0, 0}, {6, 1, 0}, {1, 1, 0}, {1, 5, 0}, {6, 5, 0}, {6, 6, 0}, {0, 6, 0}}, {0, 8}, {}, 0};
  for (unsigned i = 0; i < 8; ++i) s.verts.push_back(vert_id{i});
  return s;
}

template<class M> std::string message_for(const M& m) {
  try {
    refined(m);
  } catch (const unsupported& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE_TEMPLATE("virtual refinement is the cotangent Laplacian on simplices", M, trimesh, tetmesh) {
  const M m(jittered(grid_arrays<M>(3), 0.05));
  const Eigen::MatrixXd cotangent = laplacian(m, {.weights = weights::cotangent});
  CHECK((refined(m) + cotangent).cwiseAbs().maxCoeff() < 1e-13);
}

TEST_CASE("virtual refinement is the cotangent Laplacian on triangles among polygons") {
  const trimesh m(jittered(triangle_grid(3), 0.05));
  const polygonmesh same(with_offsets(jittered(triangle_grid(3), 0.05)));
  CHECK((refined(m) - refined(same)).cwiseAbs().maxCoeff() < 1e-14);
}

TEST_CASE_TEMPLATE("virtual refinement: positive semidefinite, the kernel is the constants, linear functions are harmonic", M, CONCINO_ALL_KINDS) {
  const M m = pushed_grid<M>(3);
  const Eigen::MatrixXd k = refined(m);
  CHECK(k.rowwise().sum().cwiseAbs().maxCoeff() < 1e-13);
  CHECK(residual_of_coordinates(m, k) < 1e-13);
  const auto values = spectrum(k);
  CHECK(std::abs(values[0]) < 1e-13);
  CHECK(values[1] > 1e-3);
  // the energy of a coordinate is the area or volume
  Eigen::VectorXd x(k.rows());
  for (const auto v : verts(m)) x[static_cast<Eigen::Index>(index_of(m, v))] = to_vec3(point(m, v)).y;
  CHECK(x.dot(k * x) == doctest::Approx(1).epsilon(1e-12));
}

TEST_CASE_TEMPLATE("virtual refinement: scales exactly, does not see where the mesh lies, the same on the archetype", M, CONCINO_ALL_KINDS) {
  auto arrays = jittered(grid_arrays<M>(2), 0.03);
  const M m(arrays);
  const Eigen::MatrixXd k = refined(m);
  const auto stripped = only_embedded_mesh(m);
  const Eigen::MatrixXd same = refined(stripped);
  const auto at = [&](const auto& v) { return static_cast<Eigen::Index>(index_of(stripped, v)); };
  const auto base = [&](const auto& v) { return static_cast<Eigen::Index>(index_of(m, stripped.base(v))); };
  for (const auto v : verts(stripped))
    for (const auto w : verts(stripped)) CHECK(same(at(v), at(w)) == doctest::Approx(k(base(v), base(w))).epsilon(1e-12));
  for (vec3& x : arrays.points) x *= 1048576;
  CHECK(refined(M(arrays)) == k * std::pow(1048576.0, dimension_v<M> - 2));
  for (vec3& x : arrays.points) x = x / 1048576 + vec3{1024, -512, 2048};
  CHECK((refined(M(arrays)) - k).cwiseAbs().maxCoeff() < 1e-9);
}

TEST_CASE("virtual refinement of the unit square and the unit cube") {
  const Eigen::MatrixXd square = refined(grid<quadmesh>(1));
  for (Eigen::Index i = 0; i < 4; ++i)
    for (Eigen::Index j = 0; j < 4; ++j) CHECK(square(i, j) == doctest::Approx(i == j ? 0.75 : -0.25));
  Eigen::VectorXd alternating(8), product(8);
  const hexmesh cube = grid<hexmesh>(1);
  for (const auto v : verts(cube)) {
    const vec3 x = point(cube, v);
    alternating[static_cast<Eigen::Index>(index_of(cube, v))] = (x.x == x.y) == (x.z == 1) ? 1 : -1;
  }
  // the virtual verts have value 0, and each of the 24 tets the gradient 2
  CHECK(alternating.dot(refined(cube) * alternating) == doctest::Approx(4));
}

TEST_CASE("virtual refinement on a mesh of other making, and of a polyhedron with more verts than are looked for one by one") {
  const auto volume = tiny::volume_example();
  const Eigen::MatrixXd k = refined(volume);
  CHECK(k.row(9).cwiseAbs().maxCoeff() == 0);
  CHECK(std::abs(spectrum(k)[1]) < 1e-13);  // the constants of the mesh and of the vert that nothing uses
  CHECK(spectrum(k)[2] > 1e-3);
  surface_arrays disk{{}, {0, 20}, {}, 0};
  for (unsigned i = 0; i < 20; ++i) {
    disk.points.push_back({std::cos(0.1 * 3.14159265358979 * i), std::sin(0.1 * 3.14159265358979 * i), 0});
    disk.verts.push_back(vert_id{i});
  }
  const polyhedralmesh prism(extrude(disk, 1));
  const Eigen::MatrixXd p = refined(prism);
  Eigen::VectorXd z(40);
  for (Eigen::Index i = 0; i < 40; ++i) z[i] = i < 20 ? 0 : 1;
  CHECK(z.dot(p * z) == doctest::Approx(total_measure(prism)));
}

TEST_CASE("virtual refinement: polys that are not star-shaped are named") {
  const polygonmesh c(letter_c());
  CHECK(message_for(c).find("poly 0 is not star-shaped") != std::string::npos);
  CHECK(message_for(c).find("standard weights") != std::string::npos);
  CHECK(message_for(polyhedralmesh(extrude(letter_c(), 1))).find("poly 0 is not star-shaped") != std::string::npos);
  // concave polys that are star-shaped are no reason
  CHECK(message_for(grid<polygonmesh>(2)).empty());
  CHECK(message_for(grid<polyhedralmesh>(2)).empty());
}

TEST_CASE_TEMPLATE("virtual refinement: polys without a measure and points that are not finite", M, CONCINO_ALL_KINDS) {
  auto arrays = grid_arrays<M>(2);
  arrays.points[1].x = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(refined(M(arrays)), invalid_mesh);
  for (vec3& x : arrays.points) x = {x.y, x.y, x.y};
  CHECK_THROWS_AS(refined(M(arrays)), invalid_mesh);
}

TEST_CASE_TEMPLATE("virtual refinement: a volume turned inside out counts as if it were not", M, CONCINO_VOLUME_KINDS) {
  auto arrays = jittered(grid_arrays<M>(2), 0.03);
  const Eigen::MatrixXd k = refined(M(arrays));
  for (vec3& x : arrays.points) x.x = -x.x;
  CHECK((refined(M(arrays)) - k).cwiseAbs().maxCoeff() < 1e-13);
}
