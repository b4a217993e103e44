#include <concino/operators/corner_gradients.hpp>

#include <concino/operators/simplex_gradients.hpp>

#include <support/kinds.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <type_traits>

using namespace concino;
using namespace concino::testing;



TEST_CASE_TEMPLATE("corner_gradients: have the verts in order, their mean and measure, and exact gradients", M, CONCINO_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.05));
  corner_gradients<M> local;
  const vec3 a{1, -2, 3};
  for (const auto p : polys(m)) {
    local.visit(m, p);
    REQUIRE(local.has_gradients());
    CHECK(local.measure == doctest::Approx(measure(m, p)).epsilon(1e-13));
    vec3 zero, sum, mean;
    std::size_t i = 0;
    for (const auto v : adj_p2v(m, p)) {
      REQUIRE(local.verts[i] == v);
      CHECK(distance(local.mean + local.points[i], to_vec3(point(m, v))) < 1e-15);
      zero += local.gradient[i];
      mean += local.points[i];
      sum += dot(a, to_vec3(point(m, v))) * local.gradient[i++];
    }
    CHECK(local.gradient.size() == i);
    CHECK(norm(zero) < 1e-13);
    CHECK(norm(mean) < 1e-14);
    vec3 expected = a;
    if constexpr (SurfaceMesh<M>) {
      CHECK(distance(local.normal, area_vector(m, p)) < 1e-15);
      expected -= dot(a, local.normal) / dot(local.normal, local.normal) * local.normal;
    }
    CHECK(distance(sum, expected) < 1e-12);
  }
}

TEST_CASE_TEMPLATE("simplex_gradients: equal corner_gradients", M, trimesh, tetmesh) {
  static_assert(std::is_same_v<poly_gradients<M>, simplex_gradients<M>>);
  static_assert(std::is_same_v<poly_gradients<hexmesh>, corner_gradients<hexmesh>>);
  auto arrays = jittered(grid_arrays<M>(2), 0.05);
  std::swap(arrays.verts[0], arrays.verts[1]);  // invert a tet
  for (vec3& x : arrays.points) x += vec3{1000, 0, -2000};
  const M m(arrays);
  corner_gradients<M> general;
  simplex_gradients<M> quick;
  for (const auto p : polys(m)) {
    general.visit(m, p);
    quick.visit(m, p);
    CHECK(quick.measure == doctest::Approx(general.measure).epsilon(1e-12));
    for (std::size_t i = 0; i < quick.corners; ++i) {
      REQUIRE(quick.verts[i] == general.verts[i]);
      CHECK(distance(quick.gradient[i], general.gradient[i]) < 1e-11);
    }
  }
}

TEST_CASE("corner_gradients: give the same result for polyhedra of few and of many verts") {
  // Prisms over regular polygons: among 26 verts a corner is found by linear search, among 80 by its index.
  for (const unsigned n : {13u, 40u}) {
    surface_arrays ring;
    ring.offsets = {0, n};
    for (unsigned i = 0; i < n; ++i) {
      ring.points.push_back({std::cos(6.2831853 * i / n), std::sin(6.2831853 * i / n), 0});
      ring.verts.push_back(vert_id{n - 1 - i});
    }
    std::reverse(ring.verts.begin(), ring.verts.end());
    const polyhedralmesh m(extrude(ring, 2));
    corner_gradients<polyhedralmesh> local;
    for (const auto p : polys(m)) {  // both with the same scratch, which keeps nothing of the poly before
      local.visit(m, p);
      vec3 sum;
      for (std::size_t i = 0; i < local.verts.size(); ++i) {
        const vec3 x = point(m, local.verts[i]);
        sum += (1 + x.x - 2 * x.z) * local.gradient[i];
      }
      CHECK(distance(sum, {1, 0, -2}) < 1e-13);
      CHECK(local.measure == doctest::Approx(measure(m, p)).epsilon(1e-13));
      CHECK(local.verts.size() == 2 * n);
    }
  }
}

TEST_CASE("corner_gradients: polys without measure, or with points that are NaN, have none") {
  corner_gradients<quadmesh> polygon;
  for (const vec3 last : {vec3{3, 0, 0}, vec3{std::nan(""), 0, 0}, vec3{0, HUGE_VAL, 0}}) {
    const quadmesh m({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, last}, {{0, 1, 2, 3}});
    polygon.visit(m, poly_id{0});
    CHECK(!polygon.has_gradients());
  }
  corner_gradients<hexmesh> polyhedron;
  for (const double bad : {1.0, std::nan(""), -HUGE_VAL}) {
    auto arrays = hex_grid(1);
    for (vec3& x : arrays.points) x.z = 1;
    arrays.points[3].z = bad;
    arrays.points[3].y = bad;
    const hexmesh m(arrays);
    polyhedron.visit(m, poly_id{0});
    CHECK(!polyhedron.has_gradients());
  }
  simplex_gradients<trimesh> triangle;
  triangle.visit(trimesh({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}, {{0, 1, 2}}), poly_id{0});
  CHECK(!triangle.has_gradients());
  const trimesh tiny_one({{0, 0, 0}, {1e-160, 0, 0}, {0, 1e-160, 0}}, {{0, 1, 2}});  // its area underflows
  triangle.visit(tiny_one, poly_id{0});
  CHECK(!triangle.has_gradients());
  const trimesh thin({{0, 0, 0}, {1, 0, 0}, {0, 1e-150, 0}}, {{0, 1, 2}});
  triangle.visit(thin, poly_id{0});
  CHECK(triangle.has_gradients());
  CHECK(triangle.gradient[2].y == doctest::Approx(1e150));
}

TEST_CASE("corner_gradients: empty polygons and extremely thin triangles have none") {
  user_mesh::surface m;
  m.polygons = {{}};
  corner_gradients<user_mesh::surface> none;
  none.visit(m, user_mesh::cell{0});
  CHECK(!none.has_gradients());
  // the area is positive, and heights over the short edges have finite inverses
  const double length = 0x1p20, height = 5e-309;
  simplex_gradients<trimesh> triangle;
  for (unsigned i = 0; i < 3; ++i) {
    const std::vector<std::array<unsigned, 3>> one{{i, (i + 1) % 3, (i + 2) % 3}};
    triangle.visit(trimesh(std::vector<vec3>{{-length, 0, 0}, {0, height, 0}, {length, 0, 0}}, one), poly_id{0});
    CHECK(triangle.measure > 0);
    CHECK(!triangle.has_gradients());
  }
}

TEST_CASE("corner_gradients: work on pyramids of a user's mesh") {
  const auto m = user_mesh::volume_example();
  corner_gradients<user_mesh::volume> local;
  local.visit(m, user_mesh::cell{1});
  CHECK(local.measure == doctest::Approx(1.0 / 3));
  vec3 sum;
  for (std::size_t i = 0; i < local.verts.size(); ++i) sum += point(m, local.verts[i])[2] * local.gradient[i];
  CHECK(distance(sum, {0, 0, 1}) < 1e-14);
}
