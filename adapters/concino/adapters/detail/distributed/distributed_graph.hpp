// Which polys of the slices of a mesh are neighbours, and parts of them by PT-Scotch.
#pragma once

#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/detail/mpi/mpi_all_to_all.hpp>
#include <concino/adapters/detail/petsc/petsc_calls.hpp>
#include <concino/concepts/facets.hpp>
#include <concino/core/message.hpp>
#include <concino/io/load_slice.hpp>

#include <petscmat.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace concino::detail {

/// The graph of the polys that this process reads, in several slices of the file.
struct slice_graph {
  /// A facet of which a slice has one poly. Its lowest three verts stand for it: if two facets of polyhedra have them
  /// in common, the parts have some facets more between them.
  struct open_facet {
    std::uint64_t verts[3];
    std::uint64_t poly;

    bool has_verts_of(const open_facet& o) const {
      return verts[0] == o.verts[0] && verts[1] == o.verts[1] && verts[2] == o.verts[2];
    }
    bool operator<(const open_facet& o) const {
      return std::lexicographical_compare(verts, verts + 3, o.verts, o.verts + 3);
    }
  };
  using pair = std::array<std::uint64_t, 2>;

  std::uint64_t first = 0, num_polys = 0, num_verts = 0;  // the first poly; the latter are those of the whole file
  std::vector<std::uint32_t> ends, inner;  // of each poly, its neighbours in its slice, as places among these polys
  std::vector<pair> outer;                 // sorted: these polys, and their neighbours in other slices
  std::vector<open_facet> open;

  std::size_t size() const { return ends.size(); }
  bool has(std::uint64_t poly) const { return poly >= first && poly < first + size(); }
  /// Calls f(place, neighbours) for each poly, with sorted numbers of polys, each once.
  template<class F>
  void for_each_row(F f) const {
    std::vector<std::uint64_t> row;
    auto next = outer.begin();
    for (std::size_t i = 0; i < size(); ++i) {
      row.clear();
      for (std::size_t k = i == 0 ? 0 : ends[i - 1]; k < ends[i]; ++k) row.push_back(first + inner[k]);
      for (; next != outer.end() && (*next)[0] == first + i; ++next) row.push_back((*next)[1]);
      std::sort(row.begin(), row.end());
      row.erase(std::unique(row.begin(), row.end()), row.end());
      f(i, row);
    }
  }
};

/// Adds the polys of the next slice of the file to a graph.
template<class M>
void append_slice(slice_graph& g, const mesh_slice<M>& s) {
  if (g.size() == 0) g.first = s.first_poly;
  g.num_polys = s.num_polys, g.num_verts = s.num_verts;
  const auto shift = static_cast<std::uint32_t>(s.first_poly - g.first);
  for (const poly_t<M> p : polys(s.mesh)) {
    for (const poly_t<M> q : adj_p2p(s.mesh, p))
      g.inner.push_back(shift + static_cast<std::uint32_t>(index_of(s.mesh, q)));
    g.ends.push_back(static_cast<std::uint32_t>(g.inner.size()));
  }
  std::vector<std::uint64_t> around;
  for (const facet_t<M> x : facets(s.mesh)) {
    if (num_elements(adj_facet2p(s.mesh, x)) != 1) continue;
    around.clear();
    for (const vert_t<M> v : adj_facet2v(s.mesh, x)) around.push_back(s.global_vert[index_of(s.mesh, v)]);
    std::sort(around.begin(), around.end());
    around.resize(std::max<std::size_t>(around.size(), 3), std::numeric_limits<std::uint64_t>::max());
    const poly_t<M> p = *adj_facet2p(s.mesh, x).begin();
    g.open.push_back({{around[0], around[1], around[2]}, s.first_poly + index_of(s.mesh, p)});
  }
}

/// The process, of so many, that is asked about a vert: they share the numbers below bound in order.
inline std::size_t process_of_vert(std::uint64_t v, std::uint64_t bound, std::size_t processes) {
  return static_cast<std::size_t>(v / (bound / processes + 1));
}
/// The verts of which process r is asked: from the first to the second - 1.
inline std::pair<std::uint64_t, std::uint64_t> verts_of_process(std::uint64_t r, std::uint64_t bound,
                                                                std::size_t processes) {
  const std::uint64_t n = bound / processes + 1;
  return {std::min(r * n, bound), std::min((r + 1) * n, bound)};
}

/// Adds the pairs of neighbours in different slices, of this process or several. Collective.
inline void join_slices(MPI_Comm communicator, slice_graph& g) {
  int size = 1;
  (MPI_Comm_size)(communicator, &size);
  const auto processes = static_cast<std::size_t>(size);
  std::vector<std::vector<slice_graph::open_facet>> sent(processes);
  on_all(communicator, [&] {
    for (const auto& x : g.open) sent[process_of_vert(x.verts[0], g.num_verts, processes)].push_back(x);
    std::vector<slice_graph::open_facet>().swap(g.open);
  });
  const auto received = all_to_all(communicator, sent);
  std::vector<std::vector<slice_graph::pair>> answers(processes);
  on_all(communicator, [&] {
    std::vector<std::pair<slice_graph::open_facet, std::size_t>> all;  // and who has it
    for (std::size_t r = 0; r < processes; ++r)
      for (const auto& x : received[r]) all.emplace_back(x, r);
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t k = 1; k < all.size(); ++k) {  // several polys at a facet become a path
      const auto& [x, of_x] = all[k - 1];
      const auto& [y, of_y] = all[k];
      if (!x.has_verts_of(y) || x.poly == y.poly) continue;
      answers[of_x].push_back({x.poly, y.poly});
      answers[of_y].push_back({y.poly, x.poly});
    }
  });
  const auto pairs = all_to_all(communicator, answers);
  on_all(communicator, [&] {
    for (const auto& of_process : pairs) g.outer.insert(g.outer.end(), of_process.begin(), of_process.end());
    std::sort(g.outer.begin(), g.outer.end());
  });
}

/// The part of each poly that this process reads, as many parts as there are processes. Collective.
inline std::vector<int> parts_of_slices(MPI_Comm communicator, const slice_graph& g) {
  int size = 1;
  (MPI_Comm_size)(communicator, &size);
  std::vector<int> part(g.size(), 0);
  if (size == 1 || g.num_polys == 0) return part;
  PetscInt *starts = nullptr, *columns = nullptr;
  const petsc_errors errors;
  on_all(communicator, [&] {
    const std::size_t most = g.inner.size() + g.outer.size();
    if (std::max<std::uint64_t>(g.num_polys, most) >= PETSC_MAX_INT)
      core::throw_joined<unsupported>(
          {"load_distributed: PETSc has too few bits to number ", g.num_polys, " polys and their neighbours"});
    errors.check(PetscMalloc1(g.size() + 1, &starts), "the partition of polys");
    errors.check(PetscMalloc1(most + 1, &columns), "the partition of polys");
    starts[0] = 0;
    g.for_each_row([&](std::size_t i, const std::vector<std::uint64_t>& row) {
      starts[i + 1] = starts[i];
      for (const std::uint64_t q : row) columns[starts[i + 1]++] = static_cast<PetscInt>(q);
    });
  });
  petsc_object<Mat, MatDestroy> graph;  // owns the arrays
  petsc_object<MatPartitioning, MatPartitioningDestroy> partitioning;
  petsc_object<IS, ISDestroy> result;
  const auto check = [&](PetscErrorCode code) {
    on_all(communicator, [&] { errors.check(code, "the partition of polys"); });
  };
  check(MatCreateMPIAdj(communicator, static_cast<PetscInt>(g.size()), static_cast<PetscInt>(g.num_polys), starts,
                        columns, nullptr, graph.address()));
  check(MatPartitioningCreate(communicator, partitioning.address()));
  check(MatPartitioningSetAdjacency(partitioning, graph));
  check(MatPartitioningSetType(partitioning, MATPARTITIONINGPTSCOTCH));
  check(MatPartitioningSetNParts(partitioning, size));
  check(MatPartitioningApply(partitioning, result.address()));
  const PetscInt* of_poly = nullptr;
  check(ISGetIndices(result, &of_poly));
  for (std::size_t i = 0; i < part.size(); ++i) part[i] = static_cast<int>(of_poly[i]);
  check(ISRestoreIndices(result, &of_poly));
  return part;
}

}  // namespace concino::detail
