// expect in 10 lines: make_vert_map<double>
#include <concino/io.hpp>
#include <concino/mesh.hpp>

#include <string>

void refused(const concino::trimesh& m) { concino::save_field(concino::make_vert_map<std::string>(m), m, "field.txt"); }
