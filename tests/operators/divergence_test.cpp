#include <concino/operators/divergence.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/operators/divergence_matrix.hpp>
#include <concino/operators/gradient.hpp>

#include <support/fields.hpp>
#include <support/kinds.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <array>

using namespace concino;
using namespace concino::testing;

namespace {

/// A vector field whose values are not vec3.
template<class M>
struct whirl {
  const M& m;
  std::array<float, 3> operator[](const poly_t<M>& p) const {
    const auto i = static_cast<float>(index_of(m, p));
    return {1 + i, 2 - i, 0.5f * i};
  }
};

template<class M>
void check_as_matrix(const M& m) {
  const whirl<M> field{m};
  Eigen::VectorXd x = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(poly_index_bound(m)));
  for (const auto p : polys(m))
    for (std::size_t k = 0; k < 3; ++k) x[static_cast<Eigen::Index>(3 * index_of(m, p) + k)] = static_cast<double>(field[p][k]);
  const Eigen::VectorXd expected = divergence_matrix(m) * x;
  const auto div = divergence(m, field);
  const double size = 1 + expected.cwiseAbs().maxCoeff();
  for (const auto v : verts(m)) CHECK(std::abs(div[v] - expected[static_cast<Eigen::Index>(index_of(m, v))]) < 1e-13 * size);
}

template<class M, class F> concept has_divergence = requires(M&& m, const F& f) { divergence(static_cast<M&&>(m), f); };

}  // namespace

TEST_CASE_TEMPLATE("divergence: equals the matrix product, for any map, also on archetypes", M, CONCINO_KINDS) {
  const M m(jittered(two_grids_arrays<M>(2), 0.05));
  check_as_matrix(m);
  check_as_matrix(only_embedded_mesh(m));
}

TEST_CASE_TEMPLATE("divergence: is right for more polys than one chunk", M, quadmesh, hexmesh) {
  const M m(jittered(grid_arrays<M>(VolumeMesh<M> ? 11 : 33), 0.003));
  REQUIRE(num_polys(m) > 1024);
  check_as_matrix(m);
}

TEST_CASE("divergence: of gradients sums to 0; handles users' meshes, empty meshes and errors") {
  const auto m = grid<polyhedralmesh>(2);
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = std::sin(point(m, v).x + 2 * point(m, v).y);
  double sum = 0;
  const auto div = divergence(m, gradient(m, u));
  for (const auto v : verts(m)) sum += div[v];
  CHECK(std::abs(sum) < 1e-13);
  check_as_matrix(user_mesh::volume_example());
  const hexmesh none;
  CHECK(divergence(none, make_poly_map<vec3>(none)).values().empty());
  const trimesh flat({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
  CHECK_THROWS_WITH_AS(divergence(flat, make_poly_map<vec3>(flat)), doctest::Contains("divergence: poly 0 has no area"), invalid_mesh);
  static_assert(has_divergence<const hexmesh&, poly_map<hexmesh, vec3>> && !has_divergence<hexmesh, poly_map<hexmesh, vec3>>);
  static_assert(!has_divergence<const hexmesh&, vert_map<hexmesh, vec3>>);
}
