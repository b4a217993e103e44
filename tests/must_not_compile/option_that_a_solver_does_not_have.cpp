// expect in 10 lines: harmonic_map_options
#include <concino/fields.hpp>
#include <concino/mesh.hpp>

auto refused(const concino::trimesh& m) { return concino::harmonic_map(m, {{concino::vert_id{0}, 1.0}}, {.power = 2}); }
