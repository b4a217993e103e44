// expect in 10 lines: give (it|the mesh) a name
#include <concino/fields.hpp>
#include <concino/mesh.hpp>

concino::trimesh made();
auto refused() { return concino::harmonic_map<concino::vec3>(made(), {{concino::vert_id{0}, concino::vec3{}}}, {.exponent = 2}); }
