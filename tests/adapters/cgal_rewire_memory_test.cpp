// Edits of CGAL::Surface_mesh and their transactions change nothing if memory runs out.
#include <concino/adapters/cgal_surface_mesh.hpp>

#include <support/cgal.hpp>
#include <support/failing_allocations.hpp>
#include <support/foreign_operators.hpp>

#include <CGAL/Simple_cartesian.h>

using namespace concino;

TEST_CASE("CGAL: edits that run out of memory change nothing") {
  const auto m = testing::cgal_surface<CGAL::Simple_cartesian<double>::Point_3>(testing::triangle_grid(2));
  testing::edits_are_all_or_nothing(m, 3, [](const auto& f) { return testing::for_each_failing_allocation(f); });
}
