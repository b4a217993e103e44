// expect in 10 lines: vert_id{0}
#include <concino/graph.hpp>
#include <concino/mesh.hpp>

auto refused(const concino::trimesh& m) { return concino::dijkstra(m, 0); }
