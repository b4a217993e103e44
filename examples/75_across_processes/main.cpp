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

namespace cn = concino;

int main(int argc, char** argv) {
  const cn::petsc_session session(argc, argv);  // PETSc and MPI run until the end of main
  const auto m = cn::make_sphere<cn::polygonmesh>({.cells = 8});
  const cn::distributed d(MPI_COMM_WORLD, m, cn::partition(m, session.num_processes(), cn::metis).part);  // divides the mesh of the first process
  const cn::vert_id a = d.vert(0), b = d.vert(d.num_global_verts() - 1);                                    // none on processes without them
  const auto u = cn::gather(cn::harmonic_map(d, {{a, 0.0}, {b, 1.0}}), m);                                  // on the first process
  if (d.rank() > 0) return 0;
  fmt::print("{} polygons\n", cn::num_polys(m));
  for (cn::vert_id v : cn::verts(m))
    if (v.raw() % 150 == 0) fmt::print("u({}) = {:.4f}\n", v.raw(), u[v]);
  if (argc > 1) cn::save_png(cn::scene().add(m, {.field = u, .isobands = 10, .edges = true}), argv[1], {.width = 240, .height = 180});
}
