// Circles, kernels, widths and curve skeletons of CGAL meshes: the same as of native ones, removed elements left out.
#include <concino/adapters/cgal_surface_mesh.hpp>
#include <concino/geometry/enclosing_ball.hpp>
#include <concino/geometry/inscribed_circle.hpp>
#include <concino/geometry/kernel.hpp>
#include <concino/geometry/width.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/skeleton/bones.hpp>
#include <concino/skeleton/nearest_bone.hpp>
#include <concino/skeleton/tube.hpp>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <support/cgal.hpp>
#include <support/meshes.hpp>

#include <doctest/doctest.h>

using namespace concino;

TEST_CASE("CGAL: circles, kernels and widths of polygons, bones of their edges") {
  const auto arrays = testing::polygon_grid(3);
  const polygonmesh native(arrays);
  auto m = testing::cgal_surface<CGAL::Simple_cartesian<double>::Point_3>(arrays);
  for (const auto p : polys(m)) {
    const poly_id q{index_of(m, p)};
    CHECK(inscribed_circle(m, p).radius == doctest::Approx(inscribed_circle(native, q).radius).epsilon(1e-8));
    CHECK(enclosing_circle(m, p).radius == doctest::Approx(enclosing_circle(native, q).radius).epsilon(1e-12));
    CHECK(kernel(m, p).area == doctest::Approx(kernel(native, q).area).epsilon(1e-12));
    CHECK(width(m, p).width == doctest::Approx(width(native, q).width).epsilon(1e-12));
  }
  CHECK(enclosing_ball(m).radius == doctest::Approx(enclosing_ball(native).radius).epsilon(1e-14));
  const auto all = bones(m);
  CHECK(all.size() == bones(native).size());
  CHECK(nearest_bone(m, all)[all[0].verts[0]] == 0);
  CHECK(num_polys(tube(m, {.radius = 0.01})) == num_polys(tube(native, {.radius = 0.01})));
  CGAL::Euler::remove_face(m.halfedge(CGAL::SM_Face_index(0)), m);
  CHECK(enclosing_ball(m).radius <= enclosing_ball(native).radius * (1 + 1e-12));
  CHECK(bones(m).size() <= all.size());
}
