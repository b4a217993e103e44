// expect in 10 lines: give (it|the mesh) a name
#include <concino/mesh.hpp>

concino::trimesh made();
auto refused() { return concino::make_poly_map<int>(made()); }
