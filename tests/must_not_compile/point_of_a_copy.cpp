// expect: mesh_traits<M>::point has to take the mesh by reference, const M&
#include <concino/concepts/mesh.hpp>

struct mine {
  double xyz[3];
  mine(const mine&);
};
template<>
struct concino::mesh_traits<mine> {
  using vert = vert_id;
  static const double* point(mine m, vert_id) { return m.xyz; }
  template<class X>
  static void set_point(mine& m, vert_id, const X& x) { m.xyz[0] = x[0]; }
};

int main() { concino::explain_mutable_points<mine>(); }
