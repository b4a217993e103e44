// expect in 10 lines: dijkstra_options
#include <concino/graph.hpp>
#include <concino/mesh.hpp>

auto refused(const concino::trimesh& m) { return concino::dijkstra(m, concino::vert_id{0}, {.max_length = 3.0}); }
