// Printability of CGAL meshes: the same as of native ones, with CGAL's own indices, removed elements left out.
#include <concino/adapters/cgal_surface_mesh.hpp>
#include <concino/print.hpp>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <support/cgal.hpp>
#include <support/printed_parts.hpp>

#include <doctest/doctest.h>

#include <vector>

using namespace concino;

TEST_CASE("CGAL: overhangs, thin walls, height map, layers and build direction") {
  const auto native = testing::voxel_part<quadmesh>(testing::table());
  auto m = testing::cgal_surface<CGAL::Simple_cartesian<double>::Point_3>(testing::voxel_skin(testing::table()));
  const auto o = overhangs(m);
  CHECK(o.support_volume == overhangs(native).support_volume);
  CHECK(o.polys.size() == overhangs(native).polys.size());
  CHECK(best_build_direction(m).direction == best_build_direction(native).direction);
  CHECK(height_map(m, {.resolution = 10}).heights == height_map(native, {.resolution = 10}).heights);
  const auto walls = thin_walls(m, 2);
  const auto expected = thin_walls(native, 2);
  REQUIRE(walls.size() == expected.size());
  for (std::size_t i = 0; i < walls.size(); ++i) {
    CHECK(index_of(m, walls[i].poly) == index_of(native, expected[i].poly));
    CHECK(walls[i].thickness == expected[i].thickness);
  }
  CHECK(narrow_gaps(m, 10).size() == narrow_gaps(native, 10).size());
  CHECK(heights(m, 0.5) == heights(native, 0.5));
  const auto layers = slice_mesh(m, {0, 1.5, 3, 4});
  const auto same = slice_mesh(native, {0, 1.5, 3, 4});
  CHECK(layers.layers == same.layers);
  CHECK(layers.layers[1].outer.size() == 4);  // the legs
  CHECK(layers.polys_of(1, slice_lines_kind::outer, 3).size() == same.polys_of(1, slice_lines_kind::outer, 3).size());
  const poly_t<decltype(m)> first = o.polys.front();
  CGAL::Euler::remove_face(m.halfedge(CGAL::SM_Face_index(static_cast<CGAL::SM_Face_index::size_type>(index_of(m, first)))), m);
  CHECK(overhangs(m).polys.size() == o.polys.size() - 1);
}
