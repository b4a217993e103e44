// expect in 10 lines: vert_id{0}
#include <concino/fields.hpp>
#include <concino/mesh.hpp>

auto refused(const concino::trimesh& m) { return concino::harmonic_map(m, {{0, 0.0}, {7, 1.0}}); }
