// expect: arity needs tables.m. to be surface_tables<arity>
#include <concino/concepts/mesh.hpp>
#include <concino/mesh/surface_tables.hpp>
#include <concino/mesh/indexed_base.hpp>

struct mine {
  concino::surface_tables<0> tables;
};
template<>
struct concino::mesh_traits<mine> : concino::indexed_surface<mine> {
  static constexpr int arity = 3;
  static const auto& tables(const mine& m) { return m.tables; }
};

bool is_mesh = concino::TriMesh<mine>;
