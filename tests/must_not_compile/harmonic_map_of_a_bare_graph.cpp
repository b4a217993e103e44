// expect in 10 lines: harmonic_map[(]m, values, uniform[)]
#include <concino/concepts/views.hpp>
#include <concino/fields/harmonic_map.hpp>
#include <concino/mesh/trimesh.hpp>

auto refused(const concino::trimesh& m) { return concino::harmonic_map(concino::primal(m), {{concino::vert_id{0}, 1.0}}, {.exponent = 2}); }
