// expect in 10 lines: give (it|the mesh) a name
#include <concino/graph.hpp>
#include <concino/mesh.hpp>

concino::trimesh made();
auto refused() { return concino::dijkstra(made(), concino::vert_id{0}); }
