// Reads a polygon mesh and computes a harmonic map, in ten lines.
#include <concino/fields/harmonic_map.hpp>
#include <concino/io/load.hpp>
#include <concino/mesh/polygonmesh.hpp>

#include <cstdio>

namespace cn = concino;

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const auto m = cn::load<cn::polygonmesh>(argv[1]);
  const auto u = cn::harmonic_map(m, {{cn::vert_id{0}, 0.0}, {cn::vert_id{1}, 1.0}});
  for (const cn::vert_id v : cn::verts(m)) std::printf("%g\n", u[v]);
}
