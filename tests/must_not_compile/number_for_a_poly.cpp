// expect in 10 lines: poly_id{0}
#include <concino/geometry.hpp>
#include <concino/mesh.hpp>

auto refused(const concino::trimesh& m) { return concino::measure(m, 0); }
