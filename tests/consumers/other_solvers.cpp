#include <concino/fields/harmonic_map.hpp>
#include <concino/generate/grid.hpp>
#include <concino/mesh/trimesh.hpp>
#include CONSUMER_HEADER

namespace cn = concino;

int main() {
  const auto m = cn::make_grid<cn::trimesh>({.cells = {4, 4}});
  const auto u = cn::harmonic_map(m, {{cn::vert_id{0}, 0.0}, {cn::vert_id{24}, 1.0}}, {}, cn::CONSUMER_SOLVER{});
  return u[cn::vert_id{12}] > 0 ? 0 : 1;
}
