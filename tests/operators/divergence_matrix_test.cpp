#include <concino/operators/divergence_matrix.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/edit.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/mesh/support/to_polyhedra.hpp>
#include <concino/operators/gradient_matrix.hpp>
#include <concino/operators/laplacian.hpp>
#include <concino/operators/mass_matrix.hpp>
#include <concino/operators/poly_mass_matrix.hpp>

#include <support/fields.hpp>
#include <support/kinds.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

namespace {

using sparse = Eigen::SparseMatrix<double>;

template<class M>
void check_is_adjoint(const M& m) {
  const auto d = divergence_matrix(m);
  check_compressed(d);
  CHECK(static_cast<std::size_t>(d.rows()) == vert_index_bound(m));
  CHECK(static_cast<std::size_t>(d.cols()) == 3 * poly_index_bound(m));
  const sparse g = gradient_matrix(m), expected = -(sparse(g.transpose()) * poly_mass_matrix(m));
  CHECK(difference(d, expected) < 1e-14);
  const Eigen::VectorXd sums = Eigen::VectorXd::Ones(d.rows()).transpose() * d;
  CHECK((sums.size() == 0 || sums.cwiseAbs().maxCoeff() < 1e-13));
}

/// The constant field c.
template<class M>
Eigen::VectorXd constant(const M& m, const vec3& c) {
  Eigen::VectorXd x(3 * static_cast<Eigen::Index>(poly_index_bound(m)));
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = c[static_cast<std::size_t>(i % 3)];
  return x;
}
template<class M>
void check_constants(const M& m, std::size_t inside_at_least) {
  const Eigen::VectorXd div = divergence_matrix(m) * constant(m, {3, -2, VolumeMesh<M> ? 1 : 0});
  const auto inside = interior_verts(m);
  std::size_t n = 0;
  for (const auto v : verts(m)) {
    if (!inside[index_of(m, v)]) continue;
    ++n;
    CHECK(std::abs(div[static_cast<Eigen::Index>(index_of(m, v))]) < 1e-12);
  }
  CHECK(n >= inside_at_least);
}

}  // namespace

TEST_CASE_TEMPLATE("divergence_matrix: is minus the transposed gradient with masses; columns sum to 0", M, CONCINO_KINDS) {
  M m(jittered(two_grids_arrays<M>(2), 0.05));
  check_is_adjoint(m);
  check_is_adjoint(only_embedded_mesh(m));
  remove_poly(m, poly_id{1});
  check_is_adjoint(m);
  CHECK(divergence_matrix(M()).size() == 0);
}

TEST_CASE_TEMPLATE("divergence_matrix: the divergence of constant fields is 0 at interior verts", M, CONCINO_KINDS) {
  check_constants(grid<M>(3), 4);
  check_constants(M(jittered(grid_arrays<M>(3), 0.05, VolumeMesh<M>)), 4);
  if constexpr (VolumeMesh<M>) check_constants(M(as_frustum(grid_arrays<M>(3))), 8);
}
TEST_CASE("divergence_matrix: the divergence of constant fields is 0 in prisms and rotated surfaces") {
  check_constants(polyhedralmesh(jittered(extrude(triangle_grid(3), 3), 0.05)), 8);
  auto turned_plane = jittered(polygon_grid(3), 0.02, false);
  for (vec3& x : turned_plane.points) x.z = 0.5 * x.x;  // the field (3, -2, 0) is not in the plane of the mesh: only its component in the plane counts
  check_constants(polygonmesh(turned_plane), 9);
}

TEST_CASE_TEMPLATE("divergence_matrix: of the gradient is the cotangent Laplacian, of the position the dimension", M, trimesh, tetmesh) {
  const M m(jittered(grid_arrays<M>(3), 0.04));
  const sparse l = laplacian(m, cotangent);
  CHECK(difference(divergence_matrix(m) * gradient_matrix(m), l) < 1e-13);
  const sparse g = gradient_matrix(m);
  CHECK(difference(sparse(g.transpose()) * poly_mass_matrix(m) * g, -l) < 1e-13);

  const M plane(jittered(grid_arrays<M>(4), 0.04, VolumeMesh<M>));
  Eigen::VectorXd position(3 * static_cast<Eigen::Index>(num_polys(plane)));
  for (const auto p : polys(plane))
    for (std::size_t k = 0; k < 3; ++k) position[static_cast<Eigen::Index>(3 * index_of(plane, p) + k)] = centroid(plane, p)[k];
  const Eigen::VectorXd div = divergence_matrix(plane) * position;
  const auto mass = vert_masses(plane);
  const auto inside = interior_verts(plane);
  std::size_t n = 0;
  for (const auto v : verts(plane))
    if (inside[index_of(plane, v)]) {
      ++n;
      CHECK(div[static_cast<Eigen::Index>(index_of(plane, v))] == doctest::Approx(dimension_v<M> * mass[v]).epsilon(1e-12));
    }
  CHECK(n == (VolumeMesh<M> ? 27 : 9));
}

TEST_CASE("divergence_matrix: accepts polygons that are triangles and polyhedra that are tets, also inverted") {
  const auto triangles = jittered(triangle_grid(2), 0.05);
  const polygonmesh polygons(with_offsets(triangles));
  CHECK(difference(divergence_matrix(polygons) * gradient_matrix(polygons), laplacian(trimesh(triangles), cotangent)) < 1e-13);
  auto tets = jittered(tet_grid(2), 0.04);
  for (std::size_t i = 0; i < tets.verts.size(); i += 8) std::swap(tets.verts[i], tets.verts[i + 1]);
  const sparse l = laplacian(tetmesh(tets), cotangent);
  const polyhedralmesh polyhedra(to_polyhedra(cell_arrays(tets)));
  CHECK(difference(divergence_matrix(tetmesh(tets)) * gradient_matrix(tetmesh(tets)), l) < 1e-13);
  CHECK(difference(divergence_matrix(polyhedra) * gradient_matrix(polyhedra), l) < 1e-13);
}

TEST_CASE_TEMPLATE("divergence_matrix: scales exactly", M, CONCINO_KINDS) {
  const auto arrays = jittered(grid_arrays<M>(2), 0.05);
  const auto d = divergence_matrix(M(arrays));
  const auto growth = [](double s) { return VolumeMesh<M> ? s * s : s; };
  for (const double s : {0x1p20, 0x1p-20}) CHECK(same_entries(divergence_matrix(M(scaled_arrays(arrays, s))), d, growth(s)));
  for (const double s : {1e6, 1e-6}) CHECK(difference(1 / growth(s) * divergence_matrix(M(scaled_arrays(arrays, s))), d) < 1e-9);
}

TEST_CASE("divergence_matrix: works on a user's mesh; errors name the poly") {
  check_is_adjoint(user_mesh::volume_example());
  const trimesh flat({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}}, {{0, 1, 2}, {0, 1, 3}});
  CHECK_THROWS_WITH_AS(divergence_matrix(flat), doctest::Contains("divergence_matrix: poly 1 has no area"), invalid_mesh);
}
