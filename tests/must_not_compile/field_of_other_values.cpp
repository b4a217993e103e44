// expect in 10 lines: make_vert_map<double>
#include <concino/core/vec3.hpp>
#include <concino/io.hpp>
#include <concino/mesh.hpp>

void refused(const concino::trimesh& m) { concino::save_field(m, concino::make_vert_map<concino::vec3>(m), "field.txt"); }
