// expect in 10 lines: make_vert_map<double>
#include <concino/mesh.hpp>
#include <concino/operators.hpp>

auto refused(const concino::trimesh& m) { return concino::gradient(m, concino::make_vert_map<concino::vec3>(m)); }
