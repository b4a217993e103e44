// expect: mesh_traits<M>::tables must take the mesh by reference
#include <concino/concepts/mesh.hpp>
#include <concino/mesh/surface_tables.hpp>
#include <concino/mesh/indexed_base.hpp>

struct mine {
  concino::surface_tables<3> tables;
};
template<>
struct concino::mesh_traits<mine> : concino::indexed_surface<mine> {
  static const auto& tables(mine m) { return m.tables; }
};

bool is_mesh = concino::SurfaceMesh<mine>;
