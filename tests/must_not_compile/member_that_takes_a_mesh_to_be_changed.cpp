// expect in 10 lines: the member is there, but cannot be called: it has to be static and public, and to take the mesh as const M&
#include <concino/concepts/primal_graph.hpp>

struct ring {};
template<>
struct concino::mesh_traits<ring> {
  using vert = vert_id;
  static id_range<vert_id> verts(const ring&);
  static unsigned num_verts(ring&);
};

int main() { concino::explain_primal_graph<ring>(); }
