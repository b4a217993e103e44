// expect: mesh_traits<M>::tables must return a reference, static const auto& tables.const M&.
#include <concino/concepts/mesh.hpp>
#include <concino/mesh/surface_tables.hpp>
#include <concino/mesh/indexed_base.hpp>

struct mine {
  concino::surface_tables<3> tables;
};
template<>
struct concino::mesh_traits<mine> : concino::indexed_surface<mine> {
  static auto tables(const mine& m) { return m.tables; }
};

bool is_mesh = concino::SurfaceMesh<mine>;
