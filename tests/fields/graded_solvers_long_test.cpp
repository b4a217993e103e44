// Harmonic maps by iteration on large grids graded by x^3 are close to linear functions, which are exact solutions on all of these meshes.
#include <support/graded_solvers.hpp>

using namespace graded_solvers;

TEST_CASE("harmonic_map: iteration is accurate on large graded grids, with all or two sides constrained") {
  for (const bool all : {true, false}) {
    CHECK(distance_from_linear(graded<trimesh>(all ? 300 : 120, 3), all) < 1e-9);
    CHECK(distance_from_linear(graded<tetmesh>(40, 3), all) < 1e-9);
    CHECK(distance_from_linear(graded<hexmesh>(30, 3), all) < 1e-9);
  }
}
