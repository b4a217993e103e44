// Components and steps of a distributed mesh; the first process of mpirun prints how many components it has, and the most steps from vert 0.
#include <concino/adapters/metis_partition.hpp>
#include <concino/adapters/parallel_bgl.hpp>
#include <concino/adapters/petsc_session.hpp>
#include <concino/mesh/trimesh.hpp>

#include <mpi.h>

#include <algorithm>
#include <cstdio>
#include <vector>

namespace cn = concino;

int main(int argc, char** argv) {
  cn::petsc_session session(argc, argv);
  const cn::trimesh m({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}}, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  const cn::distributed d(MPI_COMM_WORLD, m, cn::partition(m, 2, cn::metis).part);
  const int count = cn::connected_components(cn::dual(d)).count;
  std::vector<cn::vert_id> sources;
  for (const cn::vert_id v : cn::verts(d))
    if (d.global_number(v) == 0) sources.push_back(v);
  const auto hops = cn::bfs(d, sources);
  int most = 0;
  for (const cn::vert_id v : cn::verts(d)) most = std::max(most, hops[v]);
  MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  if (d.rank() == 0) std::printf("%d %d\n", count, most);
}
