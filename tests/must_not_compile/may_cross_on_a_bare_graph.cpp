// expect in 10 lines: may_cross(, crossed: not of a bare graph| needs the edges or faces between neighbours)
// A graph without elements between its nodes has nothing that may_cross could exclude. The message says what is missing.
#include <concino/concepts/archetypes.hpp>
#include <concino/graph/bfs.hpp>
#include <concino/mesh/trimesh.hpp>

int hops(const concino::trimesh& m, concino::vert_id v, concino::vert_id w) {
  const auto g = concino::only_primal_graph(m);
  return concino::bfs(g, g.vert(v), {.may_cross = [](auto) { return true; }})[g.vert(w)];
}
