#include <support/geodesic_check.hpp>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("heat_geodesics: errors match the table on the coarser meshes of triangles and tets", M, trimesh, tetmesh) { check_geodesics_of<M>(); }
