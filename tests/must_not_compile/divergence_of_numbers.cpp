// expect in 10 lines: make_poly_map<vec3>
#include <concino/mesh.hpp>
#include <concino/operators.hpp>

auto refused(const concino::trimesh& m) { return concino::divergence(m, concino::make_poly_map<double>(m)); }
