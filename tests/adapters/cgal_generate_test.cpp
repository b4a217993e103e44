// CGAL meshes can be generated, jittered and agglomerated.
#include <concino/adapters/cgal_surface_mesh.hpp>

#include <CGAL/Simple_cartesian.h>

#include <concino/generate.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/validate.hpp>

#include <doctest/doctest.h>

namespace cn = concino;

namespace {

using polygons = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

}  // namespace

TEST_CASE("CGAL: generating, moving and merging agree with the native mesh") {
  const cn::grid_options options{.cells = {6, 7}, .max = {2, 3, 0}};
  auto m = cn::make_grid<polygons>(options);
  auto own = cn::make_grid<cn::polygonmesh>(options);
  CHECK(cn::check_laws(m).empty());
  CHECK(cn::total_measure(m) == doctest::Approx(6));
  cn::jitter(m, 0.2);
  cn::jitter(own, 0.2);
  cn::grade(m, {2, 0.5, 1});
  cn::grade(own, {2, 0.5, 1});
  for (const auto v : cn::verts(m)) CHECK(cn::to_vec3(cn::point(m, v)) == cn::point(own, cn::vert_id{cn::index_of(m, v)}));

  const auto labels = cn::random_labels(m, 4);
  const auto merged = cn::agglomerate(m, labels);
  CHECK(cn::check_laws(merged).empty());
  CHECK(cn::num_polys(merged) < cn::num_polys(m));
  CHECK(cn::total_measure(merged) == doctest::Approx(cn::total_measure(m)).epsilon(1e-12));

  CHECK(cn::num_polys(cn::make_sphere<polygons>({.cells = 4})) == 98);
  CHECK(cn::num_polys(cn::make_torus<polygons>({.cells = {6, 5}})) == 30);
  CHECK(cn::total_measure(cn::make_box<polygons>({.cells = {2, 2, 2}})) == doctest::Approx(6));
}

TEST_CASE("CGAL: triangles, and quads of them, agree with those of the native mesh") {
  auto m = cn::make_torus<polygons>({.cells = {9, 7}});
  const auto own = cn::make_torus<cn::polygonmesh>({.cells = {9, 7}});
  const cn::trimesh triangles = cn::to_triangles(m), of_own = cn::to_triangles(own);
  REQUIRE(cn::num_polys(triangles) == cn::num_polys(of_own));
  for (const auto p : cn::polys(of_own)) CHECK(cn::measure(triangles, p) == cn::measure(of_own, p));
  CHECK(cn::num_polys(cn::quads_from_triangles(cn::convert<polygons>(triangles))) == cn::num_polys(triangles) / 2);
}
