// expect in 10 lines: a map that is not const
#include <concino/level_sets/embed.hpp>
#include <concino/mesh/trimesh.hpp>

auto refused(concino::trimesh& m) { return concino::embed_isolines(m, [](concino::vert_id) { return 1.0; }, 0.5); }
