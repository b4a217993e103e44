// expect in 10 lines: make_vert_map<double>
#include <concino/io.hpp>
#include <concino/mesh.hpp>

void refused(const concino::trimesh& m) { concino::save_field(concino::make_edge_map<double>(m), m, "field.txt"); }
