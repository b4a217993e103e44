// A file of the program mixed.cpp that uses concino header-only.
#include <concino/fields/harmonic_map.hpp>
#include <concino/mesh/polygonmesh.hpp>

#ifdef CONCINO_COMPILED
#error "this file is to be header-only"
#endif

double value_at_2(const concino::polygonmesh& m);
double value_at_2(const concino::polygonmesh& m) {
  return concino::harmonic_map(m, {{concino::vert_id{0}, 0.0}, {concino::vert_id{1}, 1.0}})[concino::vert_id{2}];
}
