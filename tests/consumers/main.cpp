// An example of a user's first program.
#include <concino/fields.hpp>
#include <concino/mesh.hpp>

#include <cstdio>

int main() {
  const concino::quadmesh m({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
  const auto u = concino::harmonic_map(m, {{concino::vert_id{0}, 0.0}, {concino::vert_id{2}, 1.0}});
  for (auto v : concino::verts(m)) std::printf("%g\n", u[v]);
}
