// CGAL: chords and blocks of meshes of quads, as of native ones, and edits of chords.
#include <concino/adapters/cgal_surface_mesh.hpp>
#include <concino/convert/convert.hpp>
#include <concino/layout.hpp>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <support/layouts.hpp>
#include <support/sheet_edits.hpp>

#include <doctest/doctest.h>

#include <algorithm>

using namespace concino;
using namespace concino::testing;

TEST_CASE("CGAL: chords, singularities, separatrices and blocks") {
  using mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  for (const auto& one : meshes_with_layouts<quadmesh>()) {
    INFO(one.name);
    if (!one.is_orientable) continue;
    const auto m = convert<mesh>(one.mesh);
    CHECK(chords(m).size() == chords(one.mesh).size());
    const auto l = coarse_layout(m);
    expect_grids(m, l);
    CHECK(l.num_blocks == coarse_layout(one.mesh).num_blocks);
    CHECK(singular_verts(m).size() == singular_verts(one.mesh).size());
    CHECK(separatrices(m).size() == separatrices(one.mesh).size());
    const auto f = *facets(m).begin();
    const auto c = chord_of(m, f);
    CHECK(std::find(c.facets.begin(), c.facets.end(), f) != c.facets.end());
  }
}

TEST_CASE("CGAL: chords are collapsed and inserted, at random too") {
  using mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  for (const auto& one : meshes_with_layouts<quadmesh>()) {
    INFO(one.name);
    if (!one.is_orientable) continue;
    auto m = convert<mesh>(one.mesh);
    const auto made = edit_layers_at_random(m, 200, 1, 2 * num_polys(m) + 200);
    CHECK(made[0] > 0);
    CHECK(made[2] > 0);
    expect_grids(m, coarse_layout(m));
  }
}
