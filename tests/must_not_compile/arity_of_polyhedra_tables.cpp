// expect: arity = 4 needs tables.m. to be tet_tables, 8 hex_tables
// Polyhedra list their verts in any order, so algorithms for hexes cannot use them.
#include <concino/concepts/mesh.hpp>
#include <concino/mesh/polyhedra_tables.hpp>
#include <concino/mesh/indexed_base.hpp>

struct mine {
  concino::polyhedra_tables tables;
};
template<>
struct concino::mesh_traits<mine> : concino::indexed_volume<mine> {
  static constexpr int arity = 8;
  static const auto& tables(const mine& m) { return m.tables; }
};

bool is_mesh = concino::HexMesh<mine>;
