// expect in 10 lines: Embedded.*point[(]m, v[)]
#include <concino/concepts/archetypes.hpp>
#include <concino/fields.hpp>
#include <concino/mesh.hpp>

auto refused(const concino::trimesh& m, concino::vert_id v) {
  const auto pure = concino::only_surface_mesh(m);
  return concino::heat_geodesics(pure, pure.vert(v));
}
