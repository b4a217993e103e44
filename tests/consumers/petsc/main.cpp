// A harmonic map that all processes of mpirun solve together, on a whole mesh and on a distributed one; the first one prints a value of each.
#include <concino/adapters/distributed.hpp>
#include <concino/adapters/distributed_gather.hpp>
#include <concino/adapters/distributed_harmonic_map.hpp>
#include <concino/adapters/metis_partition.hpp>
#include <concino/adapters/petsc.hpp>
#include <concino/fields/harmonic_map.hpp>
#include <concino/mesh/trimesh.hpp>

#include <cstdio>
#include <utility>
#include <vector>

namespace cn = concino;

int main(int argc, char** argv) {
  cn::petsc_session session(argc, argv);
  const cn::trimesh m({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}}, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  const auto u = cn::harmonic_map(m, {{cn::vert_id{0}, 0.0}, {cn::vert_id{2}, 1.0}}, {}, cn::petsc({.communicator = MPI_COMM_WORLD}));
  const cn::distributed d(MPI_COMM_WORLD, m, cn::partition(m, 2, cn::metis).part);
  std::vector<std::pair<cn::vert_id, double>> values;
  for (const cn::vert_id v : cn::verts(d))
    if (d.global_number(v) % 2 == 0 && d.global_number(v) < 4) values.emplace_back(v, d.global_number(v) == 0 ? 0.0 : 1.0);
  const auto all = cn::gather(cn::harmonic_map(d, values));
  if (d.rank() == 0) std::printf("%.6f %.6f\n", u[cn::vert_id{4}], all[4]);
}
