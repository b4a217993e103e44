// Does the same as program.cpp, with the headers of whole modules.
#include <concino/fields.hpp>
#include <concino/io.hpp>
#include <concino/mesh.hpp>

namespace cn = concino;

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  auto m = cn::load<cn::polygonmesh>(argv[1]);
  const auto u = cn::harmonic_map(m, {{cn::vert_id{0}, 0.0}, {cn::vert_id{1}, 1.0}});
  auto property = cn::vert_property<double>(m, "u");
  for (const cn::vert_id v : cn::verts(m)) property[v] = u[v];
  cn::save(m, argv[2]);
}
