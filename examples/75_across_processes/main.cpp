// The harmonic map of lesson 04 on several processes: mpirun -n 4 ./example_75_across_processes. Each holds its part of the mesh, PETSc solves on all of them
// together, and the first one prints the result, which does not depend on their number. Options of PETSc work too, such as -pc_type hypre.
#include <concino/adapters/distributed.hpp>
#include <concino/adapters/distributed_gather.hpp>
#include <concino/adapters/distributed_harmonic_map.hpp>
#include <concino/adapters/metis_partition.hpp>
#include <concino/generate.hpp>
#include <concino/mesh.hpp>
#include <concino/render/scene.hpp>
#include <concino/render/scene_png.hpp>

#include <fmt/core.h>

#include <utility>
#include <vector>

namespace cn = concino;

int main(int argc, char** argv) {
  cn::petsc_session session(argc, argv);  // PETSc and MPI run until the end of main
  int processes = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &processes);

  const auto m = cn::make_sphere<cn::polygonmesh>({.cells = 8});
  const auto parts = cn::partition(m, static_cast<std::size_t>(processes), cn::metis);
  const cn::distributed d(MPI_COMM_WORLD, m, parts.part);  // divides the mesh of the first process

  std::vector<std::pair<cn::vert_id, double>> values;
  for (const auto v : cn::verts(d))
    if (d.global_number(v) == 0 || d.global_number(v) == d.num_global_verts() - 1) values.emplace_back(v, d.global_number(v) == 0 ? 0.0 : 1.0);
  const auto u = cn::harmonic_map(d, values);  // of the whole mesh

  const auto whole = cn::gather(u);  // by number of the vert, on the first process
  if (d.rank() > 0) return 0;
  fmt::print("{} polygons\n", d.num_global_polys());
  for (std::size_t i = 0; i < whole.size(); i += 150) fmt::print("u({}) = {:.4f}\n", i, whole[i]);
  if (argc > 1) {
    auto drawn = cn::make_vert_map<double>(m, 0.0);
    for (const auto v : cn::verts(m)) drawn[v] = whole[cn::index_of(m, v)];
    cn::save_png(cn::scene().add(m, {.field = drawn, .isobands = 10, .edges = true}), argv[1], {.width = 240, .height = 180});
  }
}
