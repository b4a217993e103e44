// A harmonic map that all processes of mpirun solve together; the first one prints a value of it.
#include <concino/adapters/petsc.hpp>
#include <concino/fields/harmonic_map.hpp>
#include <concino/mesh/trimesh.hpp>

#include <cstdio>

namespace cn = concino;

int main(int argc, char** argv) {
  cn::petsc_session session(argc, argv);
  const cn::trimesh m({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}}, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  const auto u = cn::harmonic_map(m, {{cn::vert_id{0}, 0.0}, {cn::vert_id{2}, 1.0}}, {}, cn::petsc({.communicator = MPI_COMM_WORLD}));
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0) std::printf("%.6f\n", u[cn::vert_id{4}]);
}
