// OpenMesh meshes can be generated, jittered and agglomerated.
#include <support/kinds.hpp>
#include <support/openmesh.hpp>

#include <concino/edit/elements.hpp>
#include <concino/generate.hpp>
#include <concino/geometry/measure.hpp>

using namespace concino;
using namespace concino::testing::om;

TEST_CASE_TEMPLATE("OpenMesh: generated meshes obey the laws and have the right size", M, CONCINO_FIRST_OF(tri_double, poly_double, poly_eigen)) {
  const M flat = make_grid<M>({.cells = {5, 4}, .max = {5, 4, 1}});
  check_laws_hold(flat);
  CHECK(total_measure(flat) == doctest::Approx(20));
  CHECK(num_polys(flat) == (triangles_only<M> ? 40 : 22));
  const M cube = make_box<M>({.cells = {2, 2, 2}});
  CHECK(total_measure(cube) == doctest::Approx(6));
  CHECK(num_polys(make_sphere<M>({.cells = 4})) == (triangles_only<M> ? 192 : 98));
  CHECK(num_polys(make_torus<M>({.cells = {6, 5}})) == (triangles_only<M> ? 60 : 30));
}

TEST_CASE_TEMPLATE("OpenMesh: moving verts agrees with the native mesh, also with deleted polys", M, CONCINO_FIRST_OF(tri_status, poly_status)) {
  using native = std::conditional_t<triangles_only<M>, trimesh, polygonmesh>;
  native own = make_grid<native>({.cells = {6, 6}});
  M m = make_grid<M>({.cells = {6, 6}});
  jitter(own, 0.2);
  jitter(m, 0.2);
  grade(own, {2, 2, 2});
  grade(m, {2, 2, 2});
  for (const auto v : verts(m)) CHECK(to_vec3(point(m, v)) == point(own, vert_id{index_of(m, v)}));

  m.delete_face(m.face_handle(7), false);
  const auto labels = random_labels(m, 5);
  const auto merged = agglomerate(m, labels);
  CHECK(check_laws(merged).empty());
  CHECK(num_polys(merged) < num_polys(m));
  CHECK(total_measure(merged) == doctest::Approx(total_measure(m)).epsilon(1e-12));
}

TEST_CASE("OpenMesh: quads from triangles agree with those of the native mesh, also with deleted polys") {
  const surface_arrays a = concino::testing::jittered(concino::testing::triangle_grid(6), 0.02);
  trimesh own(a);
  tri_status m;
  fill(m, a);
  std::vector<poly_id> of_own, of_other;
  const polygonmesh quads = quads_from_triangles(own), others = quads_from_triangles(m);
  REQUIRE(num_polys(quads) == num_polys(others));
  for (const poly_id p : polys(quads)) CHECK(measure(others, p) == measure(quads, p));
  m.delete_face(m.face_handle(7), false);
  remove_poly(own, poly_id{7});
  CHECK(num_polys(quads_from_triangles(m, {.triangles = &of_other})) == num_polys(quads_from_triangles(own, {.triangles = &of_own})));
  CHECK(of_own == of_other);
  CHECK(of_own.size() == 1);
}

TEST_CASE("OpenMesh: triangles agree with those of the native mesh, also with deleted polys") {
  const surface_arrays a = concino::testing::polygon_grid(3);
  polygonmesh own(a);
  poly_status m;
  fill(m, a);
  m.delete_face(m.face_handle(4), false);
  remove_poly(own, poly_id{4});
  const trimesh of_own = to_triangles(own), of_other = to_triangles(m);
  REQUIRE(num_polys(of_own) == num_polys(of_other));
  for (const poly_id p : polys(of_own)) CHECK(measure(of_own, p) == measure(of_other, p));
}
