// expect in 10 lines: vert, edge and poly of mesh_traits<M> have to be different types
// Reported before missing members, as it changes the signatures of these.
#include <concino/concepts/mesh_requirements.hpp>

struct numbered {};
template<>
struct concino::mesh_traits<numbered> {
  static constexpr int dimension = 2;
  using vert = int;
  using edge = int;
  using poly = int;
};

int main() { concino::explain_surface_mesh<numbered>(); }
