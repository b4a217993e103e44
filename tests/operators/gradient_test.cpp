#include <concino/operators/gradient.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/operators/gradient_matrix.hpp>
#include <concino/operators/vert_gradient_matrix.hpp>

#include <support/fields.hpp>
#include <support/kinds.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

namespace {

/// A map that is not an array: any class with operator[] is a map.
template<class M>
struct waves {
  const M& m;
  float operator[](const vert_t<M>& v) const { return static_cast<float>(std::sin(3 * point(m, v)[0]) + point(m, v)[1] * point(m, v)[2]); }
};

template<class M>
void check_as_matrices(const M& m) {
  const waves<M> u{m};
  Eigen::VectorXd x = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(vert_index_bound(m)));
  for (const auto v : verts(m)) x[static_cast<Eigen::Index>(index_of(m, v))] = u[v];
  const Eigen::VectorXd per_poly = gradient_matrix(m) * x, per_vert = vert_gradient_matrix(m) * x;
  const auto g = gradient(m, u);
  for (const auto p : polys(m)) CHECK(distance(g[p], vector_at(per_poly, index_of(m, p))) < 1e-12);
  const auto h = vert_gradient(m, u);
  for (const auto v : verts(m)) CHECK(distance(h[v], vector_at(per_vert, index_of(m, v))) < 1e-12);
}

template<class M, class U>
concept can_take_gradient = requires(M&& m, const U& u) {
  gradient(static_cast<M&&>(m), u);
  vert_gradient(static_cast<M&&>(m), u);
};

}  // namespace

TEST_CASE_TEMPLATE("gradient, vert_gradient: equal the matrix products, for any map, also on archetypes", M, CONCINO_KINDS) {
  const M m(jittered(two_grids_arrays<M>(2), 0.05));
  check_as_matrices(m);
  check_as_matrices(only_embedded_mesh(m));
}

TEST_CASE_TEMPLATE("gradient, vert_gradient: of constants are exactly 0, however large they are", M, CONCINO_KINDS) {
  const M m(jittered(two_grids_arrays<M>(2), 0.05));
  const auto u = make_vert_map<double>(m, 1e30);
  const auto g = gradient(m, u);
  for (const auto p : polys(m)) REQUIRE(g[p] == vec3());
  const auto h = vert_gradient(m, u);
  for (const auto v : verts(m)) REQUIRE(h[v] == vec3());
}

TEST_CASE_TEMPLATE("vert_gradient: is exact on linear functions, also on the boundary; 0 at isolated verts", M, CONCINO_KINDS) {
  const M m(jittered(two_grids_arrays<M>(3), 0.04, VolumeMesh<M>));
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = 2 * point(m, v)[0] - 3 * point(m, v)[1] + point(m, v)[2] + 1;
  const auto g = vert_gradient(m, u);
  for (const auto v : verts(m)) {
    const auto around = adj_v2p(m, v);
    CHECK(distance(g[v], around.begin() != around.end() ? vec3{2, -3, VolumeMesh<M> ? 1 : 0} : vec3{}) < 1e-12);
  }
}

TEST_CASE("gradient: values that are NaN change only the polys that have them") {
  const auto m = grid<hexmesh>(2);
  auto u = make_vert_map<double>(m, 1.0);
  u[vert_id{0}] = std::nan("");
  const auto g = gradient(m, u);
  for (const auto p : polys(m)) CHECK(is_finite(g[p]) == (p != poly_id{0}));
}

TEST_CASE("gradient, vert_gradient: work on a user's mesh and empty meshes; reject temporaries") {
  check_as_matrices(user_mesh::volume_example());
  const polyhedralmesh none;
  CHECK(gradient(none, make_vert_map<double>(none)).values().empty());
  CHECK(vert_gradient(none, make_vert_map<double>(none)).values().empty());
  static_assert(can_take_gradient<const trimesh&, vert_map<trimesh, double>>);
  static_assert(!can_take_gradient<trimesh, vert_map<trimesh, double>>);
  static_assert(!can_take_gradient<const trimesh&, poly_map<trimesh, double>>);
}

TEST_CASE("gradient, vert_gradient: errors name the poly") {
  const polygonmesh m({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}}, {{0, 1, 2, 3}, {0, 1, 4}});
  const auto u = make_vert_map<double>(m, 1.0);
  CHECK_THROWS_WITH_AS(gradient(m, u), doctest::Contains("gradient: poly 1 has no area"), invalid_mesh);
  CHECK_THROWS_WITH_AS(vert_gradient(m, u), doctest::Contains("vert_gradient: poly 1 has no area"), invalid_mesh);
}
