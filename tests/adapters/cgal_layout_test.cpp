// CGAL: chords and blocks of meshes of quads, as of native ones, and edits of chords.
#include <concino/adapters/cgal_surface_mesh.hpp>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <support/foreign_layouts.hpp>

#include <doctest/doctest.h>

using mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

TEST_CASE("CGAL: chords, singularities, separatrices and blocks") { concino::testing::check_foreign_layouts<mesh>(); }

TEST_CASE("CGAL: chords are collapsed and inserted, at random too") { concino::testing::check_foreign_layer_edits<mesh>(); }
