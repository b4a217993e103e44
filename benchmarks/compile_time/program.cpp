// Reads a polygon mesh, computes a harmonic map and writes the result: the longer program whose compile time is measured.
#include <concino/fields/harmonic_map.hpp>
#include <concino/io/load.hpp>
#include <concino/io/save.hpp>
#include <concino/mesh/polygonmesh.hpp>

namespace cn = concino;

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  auto m = cn::load<cn::polygonmesh>(argv[1]);
  const auto u = cn::harmonic_map(m, {{cn::vert_id{0}, 0.0}, {cn::vert_id{1}, 1.0}});
  auto property = cn::vert_property<double>(m, "u");
  for (const cn::vert_id v : cn::verts(m)) property[v] = u[v];
  cn::save(m, argv[2]);
}
