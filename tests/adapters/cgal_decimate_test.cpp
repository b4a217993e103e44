#include <concino/adapters/cgal_surface_mesh.hpp>

#include <support/foreign_decimation.hpp>

#include <CGAL/Simple_cartesian.h>

namespace ct = concino::testing;

TEST_CASE("CGAL: decimation does what it does on a trimesh") { ct::decimates_as_trimesh_does<CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>>(); }
