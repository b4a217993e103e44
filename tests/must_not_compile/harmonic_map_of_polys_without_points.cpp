// expect in 10 lines: needs (polys and mesh_traits<M>::)?point[(]m, v[)]
#include <concino/concepts/archetypes.hpp>
#include <concino/fields/harmonic_map.hpp>
#include <concino/mesh/trimesh.hpp>

auto refused(const concino::trimesh& m) {
  const auto pure = concino::only_surface_mesh(m);
  return concino::harmonic_map(pure, {{pure.vert(concino::vert_id{0}), 1.0}});
}
