// expect in 10 lines: connected_components[(]dual[(]m[)][)]
#include <concino/concepts/archetypes.hpp>
#include <concino/graph/components.hpp>
#include <concino/mesh/trimesh.hpp>

void refused(const concino::trimesh& m) {
  const auto polys_alone = concino::only_dual_graph(m);
  concino::connected_components(polys_alone);
}
