// CGAL::Surface_mesh and arrays: repaired() to a native mesh.
#include <concino/adapters/cgal_surface_mesh.hpp>
#include <concino/adapters/span.hpp>
#include <concino/repair.hpp>
#include <concino/validate/validate.hpp>

#include <support/cgal.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <array>
#include <vector>

namespace cn = concino;

TEST_CASE("CGAL::Surface_mesh: repaired") {
  auto m = cn::testing::cgal_surface<cn::vec3>(cn::testing::two_grids_arrays<cn::trimesh>(2));
  m.add_vertex();
  const auto [mesh, fix] = cn::repaired(m);
  static_assert(std::is_same_v<std::remove_cvref_t<decltype(mesh)>, cn::polygonmesh>);
  CHECK(fix.count(cn::repair_kind::removed_verts) == 2);
  CHECK(cn::num_polys(mesh) == cn::num_polys(m));
  CHECK(cn::validate(mesh).is_clean());
}

TEST_CASE("arrays: repaired") {
  const std::vector<std::array<double, 3>> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  const std::vector<std::array<int, 3>> triangles{{0, 1, 2}, {3, 4, 5}, {0, 2, 1}};
  const auto [mesh, fix] = cn::repaired(cn::view_tri(points, triangles), {.merge_within = 0.0, .orient = true});
  CHECK(fix.done.size() == 3);
  CHECK(cn::num_verts(mesh) == 4);
  CHECK(cn::num_polys(mesh) == 2);
  CHECK(cn::validate(mesh).is_clean());
}
