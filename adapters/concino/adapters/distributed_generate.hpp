// Grids that no process can hold: make_distributed_grid<hexmesh>(MPI_COMM_WORLD, {.cells = {2000, 1000, 1000}}).
// Needs: PETSc 3.18 with MPI (Debian: petsc-dev).
#pragma once

#include <concino/adapters/detail/distributed/distributed_grid.hpp>
#include <concino/adapters/detail/distributed/distributed_records.hpp>
#include <concino/adapters/detail/distributed/distributed_verts.hpp>
#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/distributed.hpp>
#include <concino/generate/grid.hpp>

#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace concino {

/// The grid of make_grid<M>(options), of which each process makes a block; none ever holds the whole. All processes of
/// the communicator call it together, with the same options.
/// Needs:  M: one of the six meshes of this library.
/// Result: as if make_grid<M>(options) had been divided, with the same global numbers of verts and polys. The axes are
///         divided so that blocks are nearly cubes of cells, as far as the number of processes has factors; a prime
///         number gives slabs. Numbers of cells differ by at most one along an axis, and blocks are empty where an axis
///         has fewer cells than blocks. Faces of polyhedra may have other numbers and first verts.
/// Cost:   O(n log n) time and the memory of some copies, for the block and its ghosts, which come from the neighbours.
/// Errors: invalid_argument as make_grid, thrown on all processes; only a block with its ghosts must have fewer
///         elements than 32-bit descriptors.
template<class M>
distributed<M> make_distributed_grid(MPI_Comm communicator, const grid_options& options = {}) {
  int size = 1, rank = 0;
  (MPI_Comm_size)(communicator, &size);
  (MPI_Comm_rank)(communicator, &rank);
  detail::poly_records own;
  std::uint64_t vert_bound = 0;
  detail::on_all(communicator, [&] {
    detail::check_grid("make_distributed_grid", options, dimension_v<M>);
    const detail::grid_division division(options.cells, dimension_v<M>, static_cast<std::size_t>(size));
    own = detail::grid_records<M>(options, division.block(static_cast<std::size_t>(rank)));
    vert_bound = detail::num_grid_verts<M>(options);
  });
  std::vector<std::uint64_t> unused;  // a grid has no verts of no poly
  own = detail::with_ghosts(communicator, std::move(own), vert_bound, detail::from_polyhedra<M>, unused);
  detail::mesh_part<detail::part_arrays<M>> part;
  detail::on_all(communicator, [&] { part = detail::part_of_records<M>(std::move(own)); });
  return distributed<M>(communicator, std::move(part));
}

}  // namespace concino
