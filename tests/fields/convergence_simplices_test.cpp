#include <support/convergence_check.hpp>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("convergence: errors match the coarsest sizes of the table, triangles and tets", M, trimesh, tetmesh) { check_convergence_of<M>(); }
