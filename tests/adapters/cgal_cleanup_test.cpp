// CGAL::Surface_mesh: remove_unreferenced and garbage_collect.
#include <concino/adapters/cgal_surface_mesh.hpp>
#include <concino/edit/remove_unreferenced.hpp>

#include <support/cgal.hpp>
#include <support/kinds.hpp>
#include <support/rebuilt.hpp>

#include <doctest/doctest.h>

namespace cn = concino;
using cn::testing::keeps_all_laws;

TEST_CASE("CGAL::Surface_mesh: remove_unreferenced") {
  auto m = cn::testing::cgal_surface<cn::vec3>(cn::testing::two_grids_arrays<cn::trimesh>(2));
  const std::size_t n = cn::num_verts(m);
  const auto isolated = m.add_vertex();
  CHECK(cn::remove_unreferenced(m) == cn::removed_counts{2});
  CHECK_FALSE(cn::contains(m, isolated));
  CHECK(cn::num_verts(m) == n - 1);
  CHECK(m.is_valid(false));
  keeps_all_laws(m);
}
