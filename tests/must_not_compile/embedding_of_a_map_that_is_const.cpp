// expect in 10 lines: a map that is not const
#include <concino/level_sets/embed.hpp>
#include <concino/mesh/tetmesh.hpp>

auto refused(concino::tetmesh& m, const concino::vert_map<concino::tetmesh, double>& u) { return concino::embed_isosurface(m, u, 0.5); }
