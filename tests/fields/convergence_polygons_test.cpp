#include <support/convergence_check.hpp>

using namespace concino;
using namespace concino::testing;

TEST_CASE("convergence: errors match the coarsest sizes of the table, polygons") { check_convergence_of<polygonmesh>(); }
