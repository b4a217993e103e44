// Circles, kernels, widths, curve skeletons and UV maps of OpenMesh meshes: the same as of native ones, with OpenMesh's own handles, deleted elements left out.
#include <concino/adapters/openmesh.hpp>
#include <concino/generate/torus.hpp>
#include <concino/geometry/enclosing_ball.hpp>
#include <concino/geometry/inscribed_circle.hpp>
#include <concino/geometry/kernel.hpp>
#include <concino/geometry/width.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/trimesh.hpp>
#include <concino/parametrize.hpp>
#include <concino/skeleton.hpp>

#include <support/meshes.hpp>
#include <support/openmesh.hpp>

#include <doctest/doctest.h>

#include <concepts>
#include <vector>

using namespace concino;

TEST_CASE("OpenMesh: circles, kernels and widths of polygons") {
  const auto arrays = testing::polygon_grid(3);
  const polygonmesh native(arrays);
  testing::om::poly_status m;
  testing::om::fill(m, arrays);
  for (const auto p : polys(m)) {
    const poly_id q{index_of(m, p)};
    CHECK(inscribed_circle(m, p).radius == doctest::Approx(inscribed_circle(native, q).radius).epsilon(1e-8));
    CHECK(enclosing_circle(m, p).radius == doctest::Approx(enclosing_circle(native, q).radius).epsilon(1e-12));
    CHECK(enclosing_ball(m, p).radius == doctest::Approx(enclosing_ball(native, q).radius).epsilon(1e-12));
    CHECK(kernel(m, p).area == doctest::Approx(kernel(native, q).area).epsilon(1e-12));
    CHECK(width(m, p).width == doctest::Approx(width(native, q).width).epsilon(1e-12));
  }
  CHECK(enclosing_ball(m).radius == doctest::Approx(enclosing_ball(native).radius).epsilon(1e-14));
}

TEST_CASE("OpenMesh: bones of its edges, and the skeleton of a surface") {
  const auto native = make_torus<trimesh>({.cells = {16, 8}});
  testing::om::poly_status m;
  surface_arrays arrays{{}, {}, {}, 3};
  for (const auto v : verts(native)) arrays.points.push_back(point(native, v));
  for (const auto p : polys(native))
    for (const auto v : adj_p2v(native, p)) arrays.verts.push_back(v);
  testing::om::fill(m, testing::with_offsets(arrays));
  CHECK(bones(m).size() == bones(native).size());
  CHECK(joints(m).size() == num_verts(native));
  const auto s = skeleton_of(m);
  static_assert(std::same_as<decltype(s.from), std::vector<std::vector<OpenMesh::VertexHandle>>>);
  CHECK(bones(s.skeleton).size() == 1);
  CHECK(nearest_bone(m, bones(s.skeleton))[*verts(m).begin()] == 0);
  CHECK(num_polys(tube(m, {.radius = 0.01})) == num_polys(tube(native, {.radius = 0.01})));
  const auto all = bones(m).size();
  m.delete_vertex(*verts(m).begin(), false);
  CHECK(bones(m).size() < all);
  CHECK_THROWS_AS((void)skeleton_of(m), invalid_mesh);
}

TEST_CASE("OpenMesh: UV maps of its meshes") {
  auto arrays = testing::polygon_grid(3);
  for (vec3& x : arrays.points) x.z = x.x * x.y;
  const polygonmesh native(arrays);
  testing::om::poly_status m;
  testing::om::fill(m, arrays);
  const auto uv = lscm(m), same = arap_map(m, {.max_iterations = 0}).uv;
  const auto there = lscm(native);
  static_assert(std::same_as<decltype(tutte(m).attached[0].verts), std::vector<OpenMesh::VertexHandle>>);
  CHECK(tutte(m).attached.size() == tutte(native).attached.size());
  for (const auto v : verts(m))
    for (std::size_t k = 0; k < 2; ++k) {
      CHECK(uv[v][k] == doctest::Approx(there[vert_id{index_of(m, v)}][k]).epsilon(1e-5).scale(1));
      CHECK(same[v] == uv[v]);
    }
  CHECK(map_distortion(m, uv).flipped == 0);
  CHECK(map_distortion(m, injective_map(m, uv).uv).flipped == 0);
  m.delete_face(*polys(m).begin(), true);
  CHECK(num_polys(m) < num_polys(native));
  CHECK(map_distortion(m, spectral_conformal(m)).flipped == 0);
}
