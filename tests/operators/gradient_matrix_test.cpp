#include <concino/operators/gradient_matrix.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/edit.hpp>
#include <concino/mesh/support/to_polyhedra.hpp>

#include <support/fields.hpp>
#include <support/kinds.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>

using namespace concino;
using namespace concino::testing;

namespace {

/// Checks that linear functions have their exact gradient (on surfaces without its component along the vector area), and constants the gradient 0.
template<class M>
void check_linear(const M& m) {
  const auto g = gradient_matrix(m);
  check_compressed(g);
  CHECK(static_cast<std::size_t>(g.rows()) == 3 * poly_index_bound(m));
  CHECK(static_cast<std::size_t>(g.cols()) == vert_index_bound(m));
  CHECK(linear_error(m, g) < 1);
}

/// A mesh whose range of polys is in descending order, except for the last two of four.
struct backwards : user_mesh::surface {
  using user_mesh::surface::surface;
};
/// A mesh with very large indices of polys.
struct sparsely_numbered : user_mesh::surface {
  using user_mesh::surface::surface;
};

}  // namespace

template<>
struct concino::mesh_traits<backwards> : concino::mesh_traits<user_mesh::surface> {
  static auto polys(const user_mesh::surface& m) {
    auto r = user_mesh::all<user_mesh::cell>(m.polygons.size());
    std::reverse(r.begin(), r.end());
    if (r.size() == 4) std::swap(r[2], r[3]);
    return r;
  }
};
template<>
struct concino::mesh_traits<sparsely_numbered> : concino::mesh_traits<user_mesh::surface> {
  static std::size_t poly_index_bound(const user_mesh::surface&) { return std::size_t{1} << 30; }
};

TEST_CASE_TEMPLATE("gradient_matrix: is exact on linear functions, on any polys, also far from the origin", M, CONCINO_KINDS) {
  check_linear(grid<M>(2));
  check_linear(M(jittered(two_grids_arrays<M>(2), 0.04, false)));
  auto crooked = jittered(grid_arrays<M>(3), 0.06);
  check_linear(M(crooked));
  for (vec3& x : crooked.points) x += vec3{1e6, -3e7, 1e5};
  check_linear(M(crooked));
  check_linear(M(turned_arrays(as_frustum(grid_arrays<M>(2)))));
}

TEST_CASE("gradient_matrix: is exact for more polys than one chunk") { check_linear(grid<trimesh>(25)); }

TEST_CASE("gradient_matrix: is exact on prisms, on a pyramid and on a polygon of a hundred verts") {
  check_linear(polyhedralmesh(jittered(extrude(triangle_grid(2), 2), 0.05)));
  check_linear(user_mesh::volume_example());
  surface_arrays wheel;
  wheel.offsets = {0, 100};
  for (unsigned i = 0; i < 100; ++i) {
    const double t = 0.0628318 * i, r = i % 2 ? 1 : 0.7;
    wheel.points.push_back({r * std::cos(t), r * std::sin(t), 0.1 * std::cos(5 * t)});
    wheel.verts.push_back(vert_id{i});
  }
  check_linear(polygonmesh(wheel));
  for (vec3& x : wheel.points) x.z = 0;
  check_linear(polyhedralmesh(jittered(extrude(wheel, 2), 0.01)));
}

TEST_CASE("gradient_matrix: is right for one triangle, one square, one tet and one cube") {
  const auto t = gradient_matrix(trimesh({{0, 0, 0}, {2, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}));
  CHECK(Eigen::MatrixXd(t).isApprox((Eigen::MatrixXd(3, 3) << -0.5, 0.5, 0, -0.25, 0, 0.25, 0, 0, 0).finished(), 1e-15));
  const auto q = gradient_matrix(quadmesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}));
  CHECK(Eigen::MatrixXd(q).isApprox((Eigen::MatrixXd(3, 4) << -0.5, 0.5, 0.5, -0.5, -0.5, -0.5, 0.5, 0.5, 0, 0, 0, 0).finished(), 1e-15));
  const auto s = gradient_matrix(tetmesh({{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 4}}, {{0, 1, 2, 3}}));
  CHECK(Eigen::MatrixXd(s).isApprox((Eigen::MatrixXd(3, 4) << -1, 1, 0, 0, -0.5, 0, 0.5, 0, -0.25, 0, 0, 0.25).finished(), 1e-15));
  const hexmesh cube = grid<hexmesh>(1);
  const auto h = gradient_matrix(cube);
  for (const auto v : verts(cube))
    for (int k = 0; k < 3; ++k)
      CHECK(std::abs(h.coeff(k, static_cast<int>(index_of(cube, v))) - (point(cube, v)[static_cast<std::size_t>(k)] > 0.5 ? 0.25 : -0.25)) < 1e-15);
}

TEST_CASE_TEMPLATE("gradient_matrix: scales and rotates with the mesh, exactly for powers of two", M, CONCINO_KINDS) {
  const auto arrays = jittered(grid_arrays<M>(2), 0.05);
  const auto g = gradient_matrix(M(arrays));
  for (const double s : {0x1p20, 0x1p-20, 0x1p-100, 0x1p100}) CHECK(same_entries(gradient_matrix(M(scaled_arrays(arrays, s))), g, 1 / s));
  for (const double s : {1e6, 1e-6}) CHECK(difference(s * gradient_matrix(M(scaled_arrays(arrays, s))), g) < 1e-9);
  const auto r = gradient_matrix(M(turned_arrays(arrays)));
  const Eigen::VectorXd u = Eigen::VectorXd::LinSpaced(g.cols(), 0, 1).array().sin();
  const Eigen::VectorXd here = g * u, there = r * u;
  for (std::size_t p = 0; p < static_cast<std::size_t>(g.rows() / 3); ++p) CHECK(distance(turned(vector_at(here, p)), vector_at(there, p)) < 1e-12);
}

TEST_CASE_TEMPLATE("gradient_matrix: has no entries for deleted elements and isolated verts", M, CONCINO_KINDS) {
  M m(jittered(two_grids_arrays<M>(2), 0.05));
  const auto whole = gradient_matrix(m);  // the remaining polys may start at another vert or face, so sums are rounded differently
  remove_poly(m, poly_id{1});
  remove_poly(m, poly_id{5});
  const auto g = gradient_matrix(m);
  CHECK(g.rows() == whole.rows());
  for (int c = 0; c < g.cols(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator it(whole, c); it; ++it) {
      const bool gone = it.row() / 3 == 1 || it.row() / 3 == 5;
      REQUIRE(std::abs(g.coeff(it.row(), c) - (gone ? 0 : it.value())) <= (gone ? 0 : 1e-13));
    }
  std::ptrdiff_t corners = 0;
  for (const auto p : polys(m))
    for ([[maybe_unused]] const auto v : adj_p2v(m, p)) ++corners;
  CHECK(g.nonZeros() == 3 * corners);
}

TEST_CASE_TEMPLATE("gradient_matrix: works on archetypes and on an empty mesh", M, CONCINO_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.05));
  const auto g = gradient_matrix(m);
  CHECK(difference(gradient_matrix(only_embedded_mesh(m)), g) < 1e-14);
  if constexpr (arity_v<M> > 0) CHECK(difference(gradient_matrix(only_fixed_arity_mesh(m)), g) < 1e-14);
  const auto none = gradient_matrix(M());
  CHECK((none.rows() == 0 && none.cols() == 0));
}

TEST_CASE("gradient_matrix: inverted polyhedra have the same gradients") {
  auto tets = jittered(tet_grid(1), 0.05);
  const auto g = gradient_matrix(tetmesh(tets));
  const auto h = gradient_matrix(polyhedralmesh(to_polyhedra(cell_arrays(tets))));
  for (std::size_t i = 0; i < tets.verts.size(); i += 4) std::swap(tets.verts[i], tets.verts[i + 1]);
  CHECK(difference(gradient_matrix(tetmesh(tets)), g) < 1e-13);
  CHECK(difference(h, g) < 1e-13);
  CHECK(difference(gradient_matrix(polyhedralmesh(to_polyhedra(cell_arrays(tets)))), g) < 1e-13);
}

TEST_CASE("gradient_matrix: columns are sorted in any order of the verts") {
  const std::vector<std::array<double, 3>> x = {{0, 0, 0}, {1, 0.2, 0.1}, {0.3, 1, 0}, {-1, 0.4, 0}, {0.1, -1, 0.5}};
  for (const auto& p : {std::vector<user_mesh::polygon>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}}) {
    const auto g = gradient_matrix(backwards(x, p));
    check_compressed(g);
    CHECK(same_entries(g, gradient_matrix(user_mesh::surface(x, p))));
  }
}

TEST_CASE("gradient_matrix: throws if a poly has no gradient") {
  const trimesh flat({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}}, {{0, 1, 2}, {0, 1, 3}});
  CHECK_THROWS_WITH_AS(gradient_matrix(flat),
                       "gradient_matrix: poly 1 has no area, or points that are not finite, so functions on it have no gradient; "
                       "remove it or move its verts",
                       invalid_mesh);
  const tetmesh pressed({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2, 3}});
  CHECK_THROWS_WITH_AS(gradient_matrix(pressed), doctest::Contains("gradient_matrix: poly 0 has no volume"), invalid_mesh);
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    auto quads = quad_grid(2);
    quads.points.back().y = bad;
    CHECK_THROWS_WITH_AS(gradient_matrix(quadmesh(quads)), doctest::Contains("poly 3"), invalid_mesh);
    auto hexes = hex_grid(2);
    hexes.points.back().z = bad;
    CHECK_THROWS_WITH_AS(gradient_matrix(hexmesh(hexes)), doctest::Contains("poly 7"), invalid_mesh);
    auto tets = tet_grid(1);
    tets.points[1].x = bad;
    CHECK_THROWS_AS(gradient_matrix(tetmesh(tets)), invalid_mesh);
    auto triangles = triangle_grid(1);
    triangles.points[0].z = bad;
    CHECK_THROWS_AS(gradient_matrix(trimesh(triangles)), invalid_mesh);
  }
  auto crushed = hex_grid(1);
  for (vec3& x : crushed.points) x.z = 0;
  CHECK_THROWS_WITH_AS(gradient_matrix(hexmesh(crushed)), doctest::Contains("poly 0 has no volume"), invalid_mesh);
  CHECK_THROWS_WITH_AS(gradient_matrix(sparsely_numbered({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}})),
                       "gradient_matrix: the matrix would have more rows than its 32-bit indices can count; split the mesh", unsupported);
}
