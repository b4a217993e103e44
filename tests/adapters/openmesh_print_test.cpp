// Printability of OpenMesh meshes: the same as of native ones, with OpenMesh's own handles, deleted elements left out.
#include <concino/adapters/openmesh.hpp>
#include <concino/print.hpp>

#include <support/openmesh.hpp>
#include <support/printed_parts.hpp>

#include <doctest/doctest.h>

#include <concepts>
#include <vector>

using namespace concino;

TEST_CASE("OpenMesh: overhangs, thin walls, height map, layers and build direction") {
  const auto native = testing::voxel_part<quadmesh>(testing::table());
  testing::om::poly_status m;
  testing::om::fill(m, testing::voxel_skin(testing::table()));
  const auto o = overhangs(m);
  static_assert(std::same_as<decltype(o.polys), std::vector<OpenMesh::FaceHandle>>);
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
  // an open surface, after deletion without garbage collection
  const auto first = o.polys.front();
  m.delete_face(first, true);
  const auto open = overhangs(m);
  CHECK(open.polys.size() == o.polys.size() - 1);
  CHECK(open.area == o.area - 1);
}
