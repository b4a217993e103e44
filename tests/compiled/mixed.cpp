// Constructs a mesh with the compiled library, and passes it to a file that uses concino header-only.
#include <concino/fields/harmonic_map.hpp>
#include <concino/mesh/polygonmesh.hpp>

#ifndef CONCINO_COMPILED
#error "this file is to use the compiled library"
#endif

double value_at_2(const concino::polygonmesh& m);

int main() {
  const concino::polygonmesh m({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 2, 1}}, {{0, 1, 2, 3}});
  const auto u = concino::harmonic_map(m, {{concino::vert_id{0}, 0.0}, {concino::vert_id{1}, 1.0}});
  return u[concino::vert_id{2}] == value_at_2(m) ? 0 : 1;
}
