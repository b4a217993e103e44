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
#include <concino/core/message.hpp>
#include <concino/io/load_slice.hpp>
#include <concino/io/support/load_verts.hpp>
#include <concino/mesh/property_set.hpp>

#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace concino {

namespace detail {

/// Adds what happened in another slice; each sentence is there once.
inline void add_report(load_report& all, const load_report& more) {
  const auto add = [](std::vector<std::string>& to, const std::vector<std::string>& sentences) {
    for (const std::string& x : sentences)
      if (std::find(to.begin(), to.end(), x) == to.end()) to.push_back(x);
  };
  all.reoriented_polys += more.reoriented_polys;
  add(all.skipped, more.skipped);
  add(all.notes, more.notes);
}

/// Each process reads its polys in so many slices, one after another: the mesh of a slice takes more memory than what
/// is kept of it.
inline constexpr std::size_t slices_of_process = 4;

/// Calls use(slice) for each slice of this process.
template<class M, class Use>
void for_each_slice(MPI_Comm communicator, const std::string& path, const load_options& options, const Use& use) {
  int size = 1, rank = 0;
  (MPI_Comm_size)(communicator, &size);
  (MPI_Comm_rank)(communicator, &rank);
  for (std::size_t k = 0; k < slices_of_process; ++k) {
    mesh_slice<M> slice;
    on_all(communicator, [&] {
      slice = load_slice<M>(path, static_cast<std::size_t>(rank) * slices_of_process + k,
                            static_cast<std::size_t>(size) * slices_of_process, options);
    });
    use(slice);
  }
}

/// The graph of the polys that this process reads, and the properties of the file. Collective.
template<class M>
slice_graph read_graph(MPI_Comm communicator, const std::string& path, const load_options& options,
                       sent_properties& properties) {
  on_all(communicator, [] { check_petsc_is_running(); });
  slice_graph graph;
  load_report report;
  for_each_slice<M>(communicator, path, options, [&](const mesh_slice<M>& slice) {
    on_all(communicator, [&] {
      append_slice(graph, slice);
      properties.add(slice.mesh.properties(), true);
      if (options.report) add_report(report, *options.report);
    });
  });
  on_all(communicator, [&] {
    if (options.report) *options.report = report;
  });
  properties = joined_properties(communicator, properties);
  join_slices(communicator, graph);
  return graph;
}

/// Reads the slices again, and sends their polys to the processes in `part`: that is cheaper than to keep them while
/// PT-Scotch finds these. Result: the polys that belong to this process. Collective.
template<class M>
poly_records send_slices(MPI_Comm communicator, const std::string& path, const load_options& input_options,
                         std::uint64_t num_verts, const std::vector<int>& part,
                         mesh_part<part_arrays<M>>& of_part) {
  int size = 1;
  (MPI_Comm_size)(communicator, &size);
  load_options options = input_options;
  options.report = nullptr, options.progress = {};
  const sent_properties& properties = of_part.properties;
  std::vector<poly_records> parts;
  std::size_t before = 0;  // polys of earlier slices
  for_each_slice<M>(communicator, path, options, [&](mesh_slice<M>& slice) {
    poly_records some;
    std::vector<std::vector<std::size_t>> sent(static_cast<std::size_t>(size));
    on_all(communicator, [&] {
      if (slice.num_verts != num_verts || before + num_polys(slice.mesh) > part.size())
        core::throw_joined<io_error>({path, ": changes while it is read"});
      some = records_of(slice);
      const property_set values = std::move(slice.mesh.properties());
      slice.mesh = {};
      properties.append_rows(values, element_kind::vert, indices_below(some.vert_numbers.size()), some.vert_values);
      properties.append_rows(values, element_kind::poly, indices_below(some.num_polys()), some.poly_values);
      if (of_part.mesh_values.empty()) properties.append_rows(values, element_kind::mesh, {0}, of_part.mesh_values);
      for (std::size_t p = 0; p < some.num_polys(); ++p) sent[static_cast<std::size_t>(part[before + p])].push_back(p);
      before += some.num_polys();
    });
    for (poly_records& x : send_records(communicator, some, sent, from_polyhedra<M>)) parts.push_back(std::move(x));
  });
  poly_records own;
  on_all(communicator, [&] { own = merged_records(std::move(parts), from_polyhedra<M>); });
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
/// Result: as if the mesh of load<M>(path) had been divided into nearly equal parts. They may be empty where there are
///         few polys. They are connected across facets if the mesh is and no facet has three polys, by the rule of
///         partition. Faces of polyhedra may have other numbers and first verts. Each process reads four slices, one
///         after another: progress is that of each, report of all of them.
/// Cost:   O(n log n) time and the memory of some copies, for the slices, the part and its ghosts. The file is read
///         twice.
/// Errors: as load_slice, thrown on all processes. io_error if the file changes while it is read.
///         invalid_argument without a petsc_session, unsupported if 32-bit indices cannot count the pairs of
///         neighbours, solver_error if PT-Scotch fails.
/// Source: Chevalier, Pellegrini 2008, "PT-Scotch: a tool for efficient parallel graph ordering".
template<Loadable M>
distributed<M> load_distributed(MPI_Comm communicator, const std::string& path, const load_options& options = {}) {
  detail::mesh_part<detail::part_arrays<M>> part, of_file;
  detail::slice_graph graph = detail::read_graph<M>(communicator, path, options, of_file.properties);
  const std::uint64_t vert_bound = graph.num_verts;
  std::vector<int> part_of_poly = detail::parts_of_slices(communicator, graph);
  detail::join_pieces_of_slices(communicator, graph, part_of_poly);
  graph = {};
  detail::poly_records own = detail::send_slices<M>(communicator, path, options, vert_bound, part_of_poly, of_file);
  std::vector<std::uint64_t> unused;
  own = detail::with_ghosts(communicator, std::move(own), vert_bound, detail::from_polyhedra<M>, unused);
  detail::on_all(communicator, [&] {
    part = detail::part_of_records<M>(std::move(own));
    part.properties = of_file.properties, part.mesh_values = of_file.mesh_values;
    detail::add_unused_verts<M>(path, unused, options.inflate, part);
  });
  return distributed<M>(communicator, std::move(part));
}

}  // namespace concino
