// Loads a mesh that no process can hold: load_distributed<trimesh>(MPI_COMM_WORLD, "m.vtu").
// Needs: PETSc 3.18 with MPI and PT-Scotch (Debian: petsc-dev), and a petsc_session in main.
#pragma once

#include <concino/adapters/detail/distributed/distributed_graph.hpp>
#include <concino/adapters/detail/distributed/distributed_pieces.hpp>
#include <concino/adapters/detail/distributed/distributed_records.hpp>
#include <concino/adapters/detail/distributed/distributed_verts.hpp>
#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/detail/petsc/petsc_calls.hpp>
#include <concino/adapters/distributed.hpp>
#include <concino/io/load_slice.hpp>
#include <concino/io/support/load_verts.hpp>
#include <concino/mesh/property_set.hpp>

#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace concino {

namespace detail {

/// The polys that belong to this process, from the slice that it reads. The part gets the properties, and their values
/// for the mesh as a whole. Collective.
template<class M>
poly_records load_records(MPI_Comm communicator, const std::string& path, const load_options& options,
                          std::uint64_t& vert_bound, mesh_part<part_arrays<M>>& of_part) {
  int size = 1, rank = 0;
  (MPI_Comm_size)(communicator, &size);
  (MPI_Comm_rank)(communicator, &rank);
  poly_records own;
  slice_graph graph;
  property_set values;
  on_all(communicator, [&] {
    check_petsc_is_running();
    auto slice = load_slice<M>(path, static_cast<std::size_t>(rank), static_cast<std::size_t>(size), options);
    own = records_of(slice);
    graph = graph_of_slice(slice);
    values = std::move(slice.mesh.properties());
  });
  vert_bound = graph.num_verts;
  const sent_properties& properties = of_part.properties = joined_properties(communicator, values);
  on_all(communicator, [&] {
    properties.append_rows(values, element_kind::vert, indices_below(own.vert_numbers.size()), own.vert_values);
    properties.append_rows(values, element_kind::poly, indices_below(own.num_polys()), own.poly_values);
    properties.append_rows(values, element_kind::mesh, {0}, of_part.mesh_values);
    values = {};
  });
  join_slices(communicator, graph);
  std::vector<int> part = parts_of_slices(communicator, graph);
  join_pieces_of_slices(communicator, graph, part);
  std::vector<std::vector<std::size_t>> sent(static_cast<std::size_t>(size));
  on_all(communicator, [&] {
    graph = {};
    for (std::size_t p = 0; p < part.size(); ++p) sent[static_cast<std::size_t>(part[p])].push_back(p);
  });
  const std::vector<poly_records> parts = send_records(communicator, own, sent, from_polyhedra<M>);
  own = {};
  on_all(communicator, [&] { own = merged_records(parts, from_polyhedra<M>); });
  return own;
}

/// Adds verts of no poly, which the first process has.
template<class M>
void add_unused_verts(const std::string& path, const std::vector<std::uint64_t>& unused, inflate_function inflate,
                      mesh_part<part_arrays<M>>& part) {
  if (unused.empty()) return;
  load_options options;
  options.inflate = inflate;
  auto some = core::load_verts<M>(path, unused, options);
  for (const vert_t<M> v : verts(some.mesh)) part.arrays.points.push_back(point(some.mesh, v));
  part.vert_numbers.insert(part.vert_numbers.end(), unused.begin(), unused.end());
  part.vert_owners.resize(part.vert_numbers.size(), 0);
  part.properties.append_rows(some.mesh.properties(), element_kind::vert, indices_below(unused.size()),
                              part.vert_values);
}

}  // namespace detail

/// Reads a mesh, of which each process reads a slice. PT-Scotch divides the graph of the polys, and these are sent to
/// their processes; none ever holds the whole mesh. All processes of the communicator call it together, and see the
/// same file.
/// Needs:  Loadable M; a file as for load_slice, a binary .vtu or .meshb.
/// Result: as if the mesh of load<M>(path) had been divided into nearly equal parts. They are connected across facets
///         if the mesh is, by the rule of partition, and may be empty where there are few polys. Faces of polyhedra may have other numbers and first verts. progress and
///         report are those of the slice of the process.
/// Cost:   O(n log n) time and the memory of some copies, for the slice, the part and its ghosts.
/// Errors: as load_slice, thrown on all processes; a parse_error of one is an error of the same message on the others.
///         invalid_argument without a petsc_session, unsupported if 32-bit indices cannot count the pairs of
///         neighbours, solver_error if PT-Scotch fails.
/// Source: Chevalier, Pellegrini 2008, "PT-Scotch: a tool for efficient parallel graph ordering".
template<Loadable M>
distributed<M> load_distributed(MPI_Comm communicator, const std::string& path, const load_options& options = {}) {
  std::uint64_t vert_bound = 0;
  std::vector<std::uint64_t> unused;
  detail::mesh_part<detail::part_arrays<M>> part, of_file;
  detail::poly_records own = detail::load_records<M>(communicator, path, options, vert_bound, of_file);
  own = detail::with_ghosts(communicator, std::move(own), vert_bound, detail::from_polyhedra<M>, unused);
  detail::on_all(communicator, [&] {
    part = detail::part_of_records<M>(std::move(own));
    part.properties = of_file.properties, part.mesh_values = of_file.mesh_values;
    detail::add_unused_verts<M>(path, unused, options.inflate, part);
  });
  return distributed<M>(communicator, std::move(part));
}

}  // namespace concino
