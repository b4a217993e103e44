// Reads a triangle mesh and computes a harmonic map, in ten lines.
#include <concino/fields/harmonic_map.hpp>
#include <concino/io/load.hpp>
#include <concino/mesh/trimesh.hpp>

#include <cstdio>

namespace cn = concino;

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const auto m = cn::load<cn::trimesh>(argv[1]);
  const auto u = cn::harmonic_map(m, {{cn::vert_id{0}, 0.0}, {cn::vert_id{1}, 1.0}});
  for (const cn::vert_id v : cn::verts(m)) std::printf("%g\n", u[v]);
}
