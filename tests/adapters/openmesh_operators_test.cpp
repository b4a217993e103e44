// The laws of operators hold on OpenMesh's meshes, for real and generated surfaces.
#include <support/kinds.hpp>
#include <support/openmesh.hpp>

#include <support/operator_laws.hpp>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("OpenMesh: gradients are exact on linear functions, masses sum to the area, matrices scale exactly", M, CONCINO_FIRST_OF(om::tri_double, om::poly_double)) {
  operators_of_foreign_surfaces<M>();
}
