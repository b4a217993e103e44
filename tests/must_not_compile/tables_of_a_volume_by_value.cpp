// expect: mesh_traits<M>::tables must return a reference, static const auto& tables.const M&.
#include <concino/concepts/mesh.hpp>
#include <concino/mesh/polyhedra_tables.hpp>
#include <concino/mesh/indexed_base.hpp>

struct mine {
  concino::polyhedra_tables tables;
};
template<>
struct concino::mesh_traits<mine> : concino::indexed_volume<mine> {
  static concino::polyhedra_tables tables(const mine& m) { return m.tables; }
};

bool is_mesh = concino::VolumeMesh<mine>;
