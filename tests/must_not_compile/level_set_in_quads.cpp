// expect: convert<polygonmesh>
#include <concino/level_sets/embed.hpp>
#include <concino/mesh/quadmesh.hpp>

auto refused(concino::quadmesh& m) { return concino::embed_isolines(m, "u", 0.5); }
