// expect: may_have_simplices|has_weights_or_matrices
#include <concino/mesh/quadmesh.hpp>
#include <concino/operators/laplacian.hpp>

auto refused(const concino::quadmesh& m) { return concino::laplacian(m, concino::cotangent); }
