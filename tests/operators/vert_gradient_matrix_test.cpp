#include <concino/operators/vert_gradient_matrix.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/edit.hpp>
#include <concino/operators/gradient_matrix.hpp>

#include <support/fields.hpp>
#include <support/kinds.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

namespace {

/// Checks that each row is the mean of rows of the gradient matrix.
template<class M>
void check_is_mean(const M& m) {
  const auto w = vert_gradient_matrix(m);
  check_compressed(w);
  CHECK(static_cast<std::size_t>(w.rows()) == 3 * vert_index_bound(m));
  CHECK(static_cast<std::size_t>(w.cols()) == vert_index_bound(m));
  const Eigen::MatrixXd g = gradient_matrix(m), found = w;
  double largest = 0;
  for (const auto v : verts(m)) {
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(3, g.cols());
    double size = 0;
    for (const auto p : adj_v2p(m, v)) {
      sum += std::abs(measure(m, p)) * g.middleRows(3 * static_cast<Eigen::Index>(index_of(m, p)), 3);
      size += std::abs(measure(m, p));
    }
    if (size > 0) sum /= size;
    largest = std::max(largest, (found.middleRows(3 * static_cast<Eigen::Index>(index_of(m, v)), 3) - sum).cwiseAbs().maxCoeff());
  }
  CHECK(largest < 1e-13 * g.cwiseAbs().maxCoeff());
}

}  // namespace

TEST_CASE_TEMPLATE("vert_gradient_matrix: is the mean of the adjacent gradients, weighted by measure", M, CONCINO_KINDS) {
  M m(jittered(two_grids_arrays<M>(2), 0.05));
  check_is_mean(m);
  remove_poly(m, poly_id{1});
  check_is_mean(m);
  check_is_mean(only_embedded_mesh(m));
  CHECK(vert_gradient_matrix(M()).size() == 0);
}

TEST_CASE_TEMPLATE("vert_gradient_matrix: is exact on linear functions, and scales exactly", M, CONCINO_KINDS) {
  const auto arrays = jittered(two_grids_arrays<M>(2), 0.05, VolumeMesh<M>);
  const M m(arrays);
  const auto w = vert_gradient_matrix(m);
  const Eigen::VectorXd gu = w * at_verts(m, [](const vec3& x) { return 2 * x.x - x.y + 3 * x.z - 4; });
  for (const auto v : verts(m)) {
    const auto around = adj_v2p(m, v);
    CHECK(distance(vector_at(gu, index_of(m, v)), around.begin() != around.end() ? vec3{2, -1, VolumeMesh<M> ? 3 : 0} : vec3{}) < 1e-12);
  }
  for (const double s : {0x1p20, 0x1p-20}) CHECK(same_entries(vert_gradient_matrix(M(scaled_arrays(arrays, s))), w, 1 / s));
  for (const double s : {1e6, 1e-6}) CHECK(difference(s * vert_gradient_matrix(M(scaled_arrays(arrays, s))), w) < 1e-9);
}

TEST_CASE("vert_gradient_matrix: is right for more polys than one chunk") {
  auto arrays = jittered(triangle_grid(31), 0.01, false);
  arrays.points.push_back({-0.1, -0.1, 0});
  for (const unsigned v : {0u, 32u, 1024u}) arrays.verts.push_back(vert_id{v});
  const trimesh m(arrays);
  REQUIRE(num_polys(m) > 1024);
  REQUIRE(num_verts(m) == 2 * 512 + 1);
  const Eigen::VectorXd gu = vert_gradient_matrix(m) * at_verts(m, [](const vec3& x) { return 2 * x.x - x.y + 3; });
  double worst = 0;
  for (const auto v : verts(m)) worst = std::max(worst, distance(vector_at(gu, index_of(m, v)), {2, -1, 0}));
  CHECK(worst < 1e-11);
}

TEST_CASE("vert_gradient_matrix: works on a user's mesh; errors name the poly") {
  check_is_mean(user_mesh::volume_example());
  const tetmesh pressed({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2, 3}});
  CHECK_THROWS_WITH_AS(vert_gradient_matrix(pressed), doctest::Contains("vert_gradient_matrix: poly 0 has no volume"), invalid_mesh);
}
