// The laws of operators hold on CGAL's Surface_mesh, for real and generated surfaces.
#include <concino/adapters/cgal_surface_mesh.hpp>

#include <CGAL/Simple_cartesian.h>

#include <support/operator_laws.hpp>

#include <doctest/doctest.h>

TEST_CASE("CGAL: gradients are exact on linear functions, masses sum to the area, matrices scale exactly") {
  concino::testing::operators_of_foreign_surfaces<CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>>();
}
