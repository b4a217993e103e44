#include <concino/adapters/cgal_surface_mesh.hpp>

#include <support/foreign_remeshing.hpp>

#include <CGAL/Simple_cartesian.h>

namespace ct = concino::testing;

TEST_CASE("CGAL: remeshing does what it does on a trimesh") { ct::remeshes_as_trimesh_does<CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>>(); }
