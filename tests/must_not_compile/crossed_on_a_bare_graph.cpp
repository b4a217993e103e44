// expect in 10 lines: crossed(: not of a bare graph| needs the edges or faces between neighbours)
// A graph without elements between its nodes has nothing to store in `crossed`. The message says what is missing.
#include <concino/concepts/archetypes.hpp>
#include <concino/graph/bfs.hpp>
#include <concino/mesh/trimesh.hpp>

int hops(const concino::trimesh& m, concino::vert_id v, concino::vert_id w) {
  const auto g = concino::only_primal_graph(m);
  auto across = concino::make_vert_map<concino::edge_id>(g);
  return concino::bfs(g, g.vert(v), {.crossed = &across})[g.vert(w)];
}
