// expect in 10 lines: dijkstra[(]m, source, length[)]
#include <concino/concepts/archetypes.hpp>
#include <concino/graph.hpp>
#include <concino/mesh.hpp>

auto refused(const concino::trimesh& m, concino::vert_id v) {
  const auto pure = concino::only_primal_graph(m);
  return concino::dijkstra(pure, pure.vert(v));
}
