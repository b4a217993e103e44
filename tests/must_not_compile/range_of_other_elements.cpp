// expect in 10 lines: yields elements of another type
#include <concino/concepts/primal_graph.hpp>

struct ring {};
template<>
struct concino::mesh_traits<ring> {
  using vert = vert_id;
  static id_range<poly_id> verts(const ring&);
};

int main() { concino::explain_primal_graph<ring>(); }
