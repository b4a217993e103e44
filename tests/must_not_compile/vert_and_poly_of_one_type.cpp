// expect in 10 lines: vert, edge and poly of mesh_traits<M> have to be different types
// Reported even though edge is missing too, as it changes the signatures of the rest.
#include <concino/concepts/mesh.hpp>

struct numbered {};
template<>
struct concino::mesh_traits<numbered> {
  static constexpr int dimension = 2;
  using vert = int;
  using poly = int;
};

int main() { concino::explain_any_mesh<numbered>(); }
