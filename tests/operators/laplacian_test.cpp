#include <concino/operators/laplacian.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/edit/elements.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh/support/to_polyhedra.hpp>

#include <support/kinds.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <cmath>

using namespace concino;
using namespace concino::testing;

namespace {

double cot(const vec3& at, const vec3& a, const vec3& b) { return dot(a - at, b - at) / norm(cross(a - at, b - at)); }

/// Checks that rows are sorted, unique and in range in each column.
void check_compressed(const Eigen::SparseMatrix<double>& l) {
  CHECK(l.isCompressed());
  for (Eigen::Index c = 0; c < l.cols(); ++c) {
    Eigen::Index last = -1;
    for (Eigen::SparseMatrix<double>::InnerIterator it(l, c); it; ++it) {
      REQUIRE(it.row() > last);
      last = it.row();
    }
    REQUIRE(last < l.rows());
  }
}

template<class M>
void check_is_laplacian(const M& m, const Eigen::SparseMatrix<double>& l, double tolerance) {
  check_compressed(l);
  const Eigen::MatrixXd d = l;
  CHECK(d == d.transpose());
  CHECK((d * Eigen::VectorXd::Ones(d.rows())).cwiseAbs().maxCoeff() <= tolerance);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(d, Eigen::EigenvaluesOnly);
  CHECK(eigen.eigenvalues().maxCoeff() <= tolerance * 10);
  CHECK(static_cast<std::size_t>(d.rows()) == vert_index_bound(m));
}

Eigen::Index kernel_size(const Eigen::SparseMatrix<double>& l) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(Eigen::MatrixXd(l), Eigen::EigenvaluesOnly);
  return (eigen.eigenvalues().array() > -1e-10).count();
}

}  // namespace

TEST_CASE_TEMPLATE("laplacian, uniform: has entries 1 and minus the degree; the dimension of its kernel is the number of components", M, CONCINO_ALL_KINDS) {
  const M m = two_grids<M>(2);
  const auto l = laplacian(m, uniform);
  check_is_laplacian(m, l, 1e-13);
  for (const auto v : verts(m)) {
    double degree = 0;
    for (const auto w : adj_v2v(m, v)) {
      degree += 1;
      CHECK(l.coeff(static_cast<Eigen::Index>(index_of(m, w)), static_cast<Eigen::Index>(index_of(m, v))) == 1);
    }
    const auto i = static_cast<Eigen::Index>(index_of(m, v));
    CHECK(l.coeff(i, i) == -degree);
  }
  CHECK(static_cast<std::size_t>(l.nonZeros()) == num_verts(m) + 2 * num_edges(m));
  CHECK(kernel_size(l) == 3);  // two grids and the isolated vert
}

TEST_CASE_TEMPLATE("laplacian, uniform: runs on the archetype of a primal graph", M, CONCINO_ALL_KINDS) {
  const M m = grid<M>(2);
  const auto l = laplacian(m, uniform);
  CHECK(Eigen::MatrixXd(laplacian(only_primal_graph(m), uniform)) == Eigen::MatrixXd(l));
}

TEST_CASE_TEMPLATE("laplacian, virtual elements: is the default; its kernel is the constants of each component", M, CONCINO_ALL_KINDS) {
  const M m(jittered(two_grids_arrays<M>(2), 0.04, VolumeMesh<M>));
  const auto l = laplacian(m);
  check_is_laplacian(m, l, 1e-13);
  CHECK(kernel_size(l) == 3);  // two grids and the isolated vert
  CHECK((l - laplacian(m, virtual_elements)).norm() == 0);
}

TEST_CASE_TEMPLATE("laplacian, virtual elements: linear functions are harmonic at interior verts, for any polys", M, CONCINO_ALL_KINDS) {
  const M m(jittered(grid_arrays<M>(3), 0.03, VolumeMesh<M>));
  const auto l = laplacian(m);
  Eigen::VectorXd f(l.rows());
  for (const auto v : verts(m)) f[static_cast<Eigen::Index>(index_of(m, v))] = 2 * point(m, v)[0] - 3 * point(m, v)[1] + point(m, v)[2] + 4;
  const Eigen::VectorXd lf = l * f;
  std::size_t interior = 0;
  for (const auto v : verts(m)) {
    bool inside = true;
    for (std::size_t k = 0; k < (VolumeMesh<M> ? 3u : 2u); ++k) inside = inside && point(m, v)[k] > 0.1 && point(m, v)[k] < 0.9;
    if (!inside) continue;
    ++interior;
    CHECK(std::abs(lf[static_cast<Eigen::Index>(index_of(m, v))]) < 1e-12);
  }
  CHECK(interior > 0);
}

TEST_CASE("laplacian, virtual elements: is right for more polys than one chunk") {
  const quadmesh m(jittered(quad_grid(33), 0.005, false));
  REQUIRE(num_polys(m) > 1024);
  const auto l = laplacian(m);
  Eigen::VectorXd f(l.rows());
  for (const auto v : verts(m)) f[static_cast<Eigen::Index>(index_of(m, v))] = 2 * point(m, v)[0] - 3 * point(m, v)[1] + 4;
  const Eigen::VectorXd lf = l * f;
  const auto inside = [](double x) { return x > 0.015 && x < 0.985; };
  for (const auto v : verts(m))
    if (inside(point(m, v)[0]) && inside(point(m, v)[1])) CHECK(std::abs(lf[static_cast<Eigen::Index>(index_of(m, v))]) < 1e-11);
  CHECK(f.dot(lf) == doctest::Approx(-13 * total_measure(m)).epsilon(1e-11));
}

TEST_CASE_TEMPLATE("laplacian, virtual elements: equals the cotangent Laplacian if all polys are triangles or tets", M, trimesh, tetmesh) {
  const auto arrays = jittered(grid_arrays<M>(2), 0.05);
  const M m(arrays);
  const Eigen::MatrixXd expected = laplacian(m, cotangent);
  CHECK(Eigen::MatrixXd(laplacian(m)) == expected);
  if constexpr (SurfaceMesh<M>)
    CHECK((Eigen::MatrixXd(laplacian(polygonmesh(with_offsets(arrays)))) - expected).cwiseAbs().maxCoeff() < 1e-13);
  else
    CHECK((Eigen::MatrixXd(laplacian(polyhedralmesh(to_polyhedra(cell_arrays(arrays))))) - expected).cwiseAbs().maxCoeff() < 1e-13);
}

TEST_CASE_TEMPLATE("laplacian, virtual elements: scales exactly as lengths to the dimension minus two", M, CONCINO_ALL_KINDS) {
  auto arrays = jittered(grid_arrays<M>(2), 0.03, VolumeMesh<M>);
  const auto original = arrays.points;
  const auto l = Eigen::MatrixXd(laplacian(M(arrays)));
  for (const double s : {0x1p20, 0x1p-20}) {
    for (std::size_t i = 0; i < original.size(); ++i) arrays.points[i] = s * original[i];
    CHECK(Eigen::MatrixXd(laplacian(M(arrays))) == l * (VolumeMesh<M> ? s : 1.0));
  }
  for (const double s : {1e6, 1e-6}) {
    for (std::size_t i = 0; i < original.size(); ++i) arrays.points[i] = s * original[i];
    const Eigen::MatrixXd expected = l * (VolumeMesh<M> ? s : 1.0);
    CHECK((Eigen::MatrixXd(laplacian(M(arrays))) - expected).cwiseAbs().maxCoeff() <= 1e-9 * expected.cwiseAbs().maxCoeff());
  }
}

TEST_CASE_TEMPLATE("laplacian, virtual elements: is the same on the archetype, and works with gaps in the indices", M, CONCINO_ALL_KINDS) {
  M m(jittered(grid_arrays<M>(3), 0.02, VolumeMesh<M>));
  const auto same_on_archetype = [&] {
    const auto l = laplacian(m);
    check_is_laplacian(m, l, 1e-12);
    const auto g = only_embedded_mesh(m);
    const auto stripped = laplacian(g);
    double worst = 0;
    for (const auto v : verts(g))
      for (const auto w : verts(g))
        worst = std::max(worst, std::abs(stripped.coeff(static_cast<int>(index_of(g, v)), static_cast<int>(index_of(g, w))) -
                                         l.coeff(static_cast<int>(index_of(m, g.base(v))), static_cast<int>(index_of(m, g.base(w))))));
    CHECK(worst < 1e-12);
  };
  same_on_archetype();
  const vert_id gone{static_cast<unsigned>(num_verts(m) / 2)};
  remove_vert(m, gone);
  same_on_archetype();
  CHECK(laplacian(m).col(static_cast<Eigen::Index>(gone.raw())).nonZeros() == 0);
}

TEST_CASE_TEMPLATE("laplacian, virtual elements: the error names polys without a measure and points that are NaN", M, CONCINO_ALL_KINDS) {
  auto arrays = grid_arrays<M>(1);
  auto flat = arrays;
  for (vec3& x : flat.points) x.y = x.z = 0;
  CHECK_THROWS_WITH_AS(laplacian(M(flat)), doctest::Contains("virtual elements: poly 0"), invalid_mesh);
  M m(arrays);
  for (const double bad : {std::nan(""), HUGE_VAL}) {
    const double x[3] = {bad, 0, 0};
    set_point(m, vert_id{0}, x);
    CHECK_THROWS_WITH_AS(laplacian(m), doctest::Contains("virtual elements: poly 0"), invalid_mesh);
  }
}

TEST_CASE("laplacian, cotangent: has half the sum of the cotangents opposite each edge") {
  const trimesh m({{0, 0, 0}, {2, 0, 0.3}, {0.5, 1, 0}, {1.5, -1, 0.2}}, {{0, 1, 2}, {1, 0, 3}});
  const auto l = laplacian(m, cotangent);
  const auto x = [&](unsigned i) { return to_vec3(point(m, vert_id{i})); };
  CHECK(l.coeff(0, 1) == doctest::Approx(0.5 * (cot(x(2), x(0), x(1)) + cot(x(3), x(0), x(1)))).epsilon(1e-14));
  CHECK(l.coeff(1, 2) == doctest::Approx(0.5 * cot(x(0), x(1), x(2))).epsilon(1e-14));
  CHECK(l.coeff(0, 3) == doctest::Approx(0.5 * cot(x(1), x(0), x(3))).epsilon(1e-14));
  CHECK(l.coeff(2, 3) == 0);
}

TEST_CASE("laplacian, cotangent: negative weights are kept") {
  const trimesh m({{0, 0, 0}, {4, 0, 0}, {2, 0.5, 0}}, {{0, 1, 2}});
  const auto l = laplacian(m, cotangent);
  CHECK(l.coeff(0, 1) < -0.9);
  check_is_laplacian(m, l, 1e-13);
}

TEST_CASE("laplacian, cotangent: is right for a tet, by the dihedral angles at opposite edges") {
  const std::vector<vec3> x = {{0, 0, 0}, {2, 0.1, 0}, {0.4, 1.5, 0.2}, {0.3, 0.6, 1.7}};
  const tetmesh m(x, std::vector<std::vector<int>>{{0, 1, 2, 3}});
  const tetmesh inverted(x, std::vector<std::vector<int>>{{1, 0, 2, 3}});
  const auto l = laplacian(m, cotangent);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      std::size_t others[2], n = 0;
      for (std::size_t k = 0; k < 4; ++k)
        if (k != i && k != j) others[n++] = k;
      const vec3 axis = x[others[1]] - x[others[0]];
      const auto beside = [&](std::size_t k) { return (x[k] - x[others[0]]) - dot(x[k] - x[others[0]], axis) / dot(axis, axis) * axis; };
      const vec3 a = beside(i), b = beside(j);
      const double expected = norm(axis) * dot(a, b) / norm(cross(a, b)) / 6;
      CHECK(l.coeff(static_cast<int>(i), static_cast<int>(j)) == doctest::Approx(expected).epsilon(1e-13));
    }
  check_is_laplacian(m, l, 1e-13);
  CHECK((Eigen::MatrixXd(l) - Eigen::MatrixXd(laplacian(inverted, cotangent))).cwiseAbs().maxCoeff() < 1e-14);
}

TEST_CASE_TEMPLATE("laplacian, cotangent: linear functions are harmonic at interior verts", M, trimesh, tetmesh) {
  const M m(jittered(grid_arrays<M>(4), 0.06, VolumeMesh<M>));
  const auto l = laplacian(m, cotangent);
  check_is_laplacian(m, l, 1e-11);
  Eigen::VectorXd f(l.rows());
  for (const auto v : verts(m)) f[static_cast<Eigen::Index>(index_of(m, v))] = 2 * point(m, v)[0] - 3 * point(m, v)[1] + point(m, v)[2] + 4;
  const Eigen::VectorXd lf = l * f;
  std::size_t interior = 0;
  for (const auto v : verts(m)) {
    bool inside = true;
    for (std::size_t k = 0; k < (VolumeMesh<M> ? 3u : 2u); ++k) inside = inside && point(m, v)[k] > 0.1 && point(m, v)[k] < 0.9;
    if (!inside) continue;
    ++interior;
    CHECK(std::abs(lf[static_cast<Eigen::Index>(index_of(m, v))]) < 1e-11);
  }
  CHECK(interior == (VolumeMesh<M> ? 27 : 9));
}

TEST_CASE_TEMPLATE("laplacian, cotangent: scales as lengths to the dimension minus two", M, trimesh, tetmesh) {
  auto arrays = jittered(grid_arrays<M>(2), 0.05);
  const auto l = Eigen::MatrixXd(laplacian(M(arrays), cotangent));
  for (vec3& x : arrays.points) x *= 0x1p-30;
  const auto s = Eigen::MatrixXd(laplacian(M(arrays), cotangent));
  CHECK(s == l * (VolumeMesh<M> ? 0x1p-30 : 1.0));
}

TEST_CASE("laplacian, cotangent: accepts polygons that are triangles and polyhedra that are tets") {
  const auto arrays = jittered(triangle_grid(2), 0.05);
  const auto as_polygons = laplacian(polygonmesh(with_offsets(arrays)), cotangent);
  CHECK(Eigen::MatrixXd(as_polygons) == Eigen::MatrixXd(laplacian(trimesh(arrays), cotangent)));

  const std::vector<vec3> x = {{0, 0, 0}, {2, 0.1, 0}, {0.4, 1.5, 0.2}, {0.3, 0.6, 1.7}};
  polyhedra_arrays tet;
  tet.points = x;
  tet.face_offsets = {0, 3, 6, 9, 12};
  for (const unsigned v : {0u, 2u, 1u, 0u, 1u, 3u, 0u, 3u, 2u, 1u, 2u, 3u}) tet.face_verts.push_back(vert_id{v});
  tet.poly_offsets = {0, 4};
  for (const unsigned f : {0u, 1u, 2u, 3u}) tet.poly_faces.push_back(face_id{f});
  tet.outward = {1, 1, 1, 1};
  const auto l = laplacian(polyhedralmesh(tet), cotangent);
  const auto expected = laplacian(tetmesh(x, std::vector<std::vector<int>>{{0, 1, 2, 3}}), cotangent);
  CHECK((Eigen::MatrixXd(l) - Eigen::MatrixXd(expected)).cwiseAbs().maxCoeff() < 1e-14);
}

TEST_CASE("laplacian, cotangent: the order of the edges of a poly does not matter") {
  const auto same = [](const auto& m, const auto& other) {
    const Eigen::MatrixXd a = laplacian(m, cotangent), b = laplacian(other, cotangent);
    REQUIRE(a.rows() == b.rows());
    CHECK((a - b).cwiseAbs().maxCoeff() < 1e-12);
  };
  const auto tets = jittered(tet_grid(2), 0.05);
  same(tetmesh(tets), polyhedralmesh(to_polyhedra(cell_arrays(tets))));
  for (unsigned turn = 0; turn < 6; ++turn) {  // the order of edges depends on the first poly that has them
    auto turned = tets;
    const unsigned orders[][4] = {{1, 2, 0, 3}, {3, 1, 0, 2}, {1, 0, 3, 2}, {2, 3, 0, 1}, {0, 3, 1, 2}, {3, 2, 1, 0}};
    for (std::size_t p = 0; p < turned.num_polys(); ++p)
      if (p % 2 == turn % 2)
        for (unsigned k = 0; k < 4; ++k) turned.verts[4 * p + k] = tets.verts[4 * p + orders[turn][k]];
    same(tetmesh(tets), tetmesh(turned));
    same(tetmesh(tets), polyhedralmesh(to_polyhedra(cell_arrays(turned))));
  }
}

TEST_CASE("laplacian, cotangent: runs on archetypes of meshes, and rejects graphs") {
  const auto m = grid<tetmesh>(2);
  const auto t = grid<trimesh>(2);
  CHECK(Eigen::MatrixXd(laplacian(only_embedded_mesh(t), cotangent)).isApprox(Eigen::MatrixXd(laplacian(t, cotangent))));
  CHECK(Eigen::MatrixXd(laplacian(only_embedded_mesh(m), cotangent)).isApprox(Eigen::MatrixXd(laplacian(m, cotangent))));
  using graph = decltype(only_primal_graph(m));
  static_assert(!Discretisation<cotangent_t, graph> && !Discretisation<virtual_elements_t, graph> && Discretisation<uniform_t, graph>);
}

TEST_CASE("laplacian, cotangent: errors name the poly") {
  const polygonmesh mixed({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}}, {{1, 4, 2}, {0, 1, 2, 3}});
  CHECK_THROWS_WITH_AS(laplacian(mixed, cotangent),
                       "cotangent weights: poly 1 has 4 verts and is not a triangle; use virtual_elements or uniform, or split the polys", unsupported);
  static_assert(!Discretisation<cotangent_t, hexmesh> && !Discretisation<cotangent_t, quadmesh>);
  CHECK_THROWS_WITH_AS(laplacian(polyhedralmesh(to_polyhedra(cell_arrays(grid_arrays<hexmesh>(1)))), cotangent),
                       "cotangent weights: poly 0 has 8 verts and is not a tet; use virtual_elements or uniform, or split the polys", unsupported);
  const trimesh flat({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}}, {{0, 1, 2}, {0, 1, 3}});
  CHECK_THROWS_WITH_AS(laplacian(flat, cotangent), doctest::Contains("poly 1 is degenerate"), invalid_mesh);
  const tetmesh pressed({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2, 3}});
  CHECK_THROWS_WITH_AS(laplacian(pressed, cotangent), doctest::Contains("poly 0 is degenerate"), invalid_mesh);
}

TEST_CASE_TEMPLATE("laplacian: is empty for an empty mesh, and 0 for isolated verts", M, CONCINO_ALL_KINDS) {
  CHECK(laplacian(M()).size() == 0);
  auto arrays = grid_arrays<M>(1);
  using arrays_type = decltype(arrays);
  arrays_type alone;
  alone.points = arrays.points;
  if constexpr (requires { alone.arity; }) alone.arity = arrays.arity;
  const auto l = laplacian(M(alone));
  CHECK(static_cast<std::size_t>(l.rows()) == arrays.points.size());
  CHECK(Eigen::MatrixXd(l).isZero(0));
}

TEST_CASE("laplacian: is right for a fan of a thousand triangles, three of them at one edge") {
  std::vector<vec3> x = {{0, 0, 0}};
  std::vector<std::vector<int>> polys_;
  const int n = 1000;
  for (int i = 0; i < n; ++i) x.push_back({std::cos(i * 6.28 / n), std::sin(i * 6.28 / n), 0});
  for (int i = n; i > 1; --i) polys_.push_back({0, i - 1, i});
  x.push_back({0.2, 0.1, 1});
  polys_.push_back({0, 1, n + 1});
  polys_.push_back({0, 2, n + 1});
  const trimesh m(x, polys_);
  const auto check = [&](const auto& which) {
    const auto l = laplacian(m, which);
    check_compressed(l);
    CHECK((l * Eigen::VectorXd::Ones(l.rows())).cwiseAbs().maxCoeff() < 1e-9);
  };
  check(uniform);
  check(cotangent);
  CHECK(laplacian(m, uniform).coeff(0, 0) == -(n + 1));
}

TEST_CASE("laplacian, cotangent: works on a user's mesh, and throws if a coordinate is NaN") {
  user_mesh::surface m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  const auto l = laplacian(m, cotangent);
  CHECK(l.coeff(1, 2) == doctest::Approx(0));
  CHECK(l.coeff(0, 1) == doctest::Approx(0.5));
  for (const double bad : {std::nan(""), HUGE_VAL}) {
    m.points[1][0] = bad;
    CHECK_THROWS_AS(laplacian(m, cotangent), invalid_mesh);
  }
}
