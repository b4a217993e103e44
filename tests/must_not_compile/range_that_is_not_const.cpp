// expect in 10 lines: begin[(][)] of what it returns is not const
// The member exists, and the message says what is wrong with it.
#include <concino/concepts/primal_graph.hpp>

struct ring {};
struct walk {
  concino::vert_id* begin();
  concino::vert_id* end();
};
template<>
struct concino::mesh_traits<ring> {
  using vert = vert_id;
  static walk verts(const ring&);
};

int main() { concino::explain_primal_graph<ring>(); }
