// Connected parts of the polys of slices: the pieces of a part but its largest join a neighbouring part.
#pragma once

#include <concino/adapters/detail/distributed/distributed_graph.hpp>
#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/detail/mpi/mpi_all_to_all.hpp>
#include <concino/adapters/detail/partition/partition_graph.hpp>

#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace concino::detail {

/// A connected piece of the polys of a part that one process reads, as a node of a graph of all these.
struct slice_piece {
  std::uint64_t size;
  int part;
};
/// Two of them, by number, and how many pairs of their polys are neighbours.
struct slice_piece_edge {
  std::uint64_t from, to, weight;

  bool operator<(const slice_piece_edge& o) const { return std::pair(from, to) < std::pair(o.from, o.to); }
};

/// The graph of the polys of this process alone.
inline partition_graph graph_within(const slice_graph& g) {
  partition_graph r;
  r.offsets.reserve(g.size() + 1);
  g.for_each_row([&](std::size_t, const std::vector<std::uint64_t>& row) {
    for (const std::uint64_t q : row)
      if (g.has(q)) r.neighbours.push_back(static_cast<int>(q - g.first));
    r.offsets.push_back(static_cast<int>(r.neighbours.size()));
  });
  return r;
}

/// Adds up the weights of equal edges.
inline void unite_edges(std::vector<slice_piece_edge>& edges) {
  std::sort(edges.begin(), edges.end());
  std::vector<slice_piece_edge> united;
  for (const slice_piece_edge& e : edges) {
    if (united.empty() || united.back() < e) united.push_back(e);
    else united.back().weight += e.weight;
  }
  edges.swap(united);
}

/// The edges between pieces, from those of this process. Its pieces have the numbers from first_piece on. Collective.
inline std::vector<slice_piece_edge> edges_of_pieces(MPI_Comm communicator, const slice_graph& g,
                                                     const partition_pieces& pieces, std::uint64_t first_piece) {
  struct neighbour {
    std::uint64_t piece, poly;  // of the sender, and of the receiver
  };
  int size = 1;
  (MPI_Comm_size)(communicator, &size);
  std::vector<std::uint64_t> first_polys(static_cast<std::size_t>(size));
  (MPI_Allgather)(&g.first, 1, MPI_UINT64_T, first_polys.data(), 1, MPI_UINT64_T, communicator);
  const auto piece_of = [&](std::uint64_t poly) {
    return first_piece + pieces.piece_of[static_cast<std::size_t>(poly - g.first)];
  };
  std::vector<slice_piece_edge> edges;
  std::vector<std::vector<neighbour>> sent(first_polys.size());
  on_all(communicator, [&] {
    g.for_each_row([&](std::size_t i, const std::vector<std::uint64_t>& row) {
      const std::uint64_t piece = piece_of(g.first + i);
      for (const std::uint64_t q : row) {
        const auto after = std::upper_bound(first_polys.begin(), first_polys.end(), q);
        if (!g.has(q)) sent[static_cast<std::size_t>(after - first_polys.begin() - 1)].push_back({piece, q});
        else if (piece != piece_of(q)) edges.push_back({piece, piece_of(q), 1});
      }
    });
  });
  const auto received = all_to_all(communicator, sent);
  on_all(communicator, [&] {
    for (const auto& of_process : received)
      for (const neighbour& x : of_process) edges.push_back({piece_of(x.poly), x.piece, 1});
    unite_edges(edges);
  });
  return edges;
}

/// The graph of the pieces of all processes.
inline partition_graph graph_of_pieces(const std::vector<std::vector<slice_piece>>& nodes,
                                       const std::vector<std::vector<slice_piece_edge>>& edges) {
  partition_graph g;
  for (const auto& of_process : nodes)
    for (const slice_piece& x : of_process) g.sizes.push_back(static_cast<std::size_t>(x.size));
  g.offsets.assign(g.sizes.size() + 1, 0);
  for (const auto& of_process : edges)
    for (const slice_piece_edge& e : of_process) {
      ++g.offsets[static_cast<std::size_t>(e.from) + 1];
      g.neighbours.push_back(static_cast<int>(e.to));
      g.weights.push_back(static_cast<std::size_t>(e.weight));
    }
  for (std::size_t i = 0; i < g.sizes.size(); ++i) g.offsets[i + 1] += g.offsets[i];
  return g;
}

/// join_pieces for the polys of all slices; part is that of each poly that this process reads. The first process
/// joins pieces in the graph of those that one process reads, which is small. Collective.
inline void join_pieces_of_slices(MPI_Comm communicator, const slice_graph& g, std::vector<int>& part) {
  int size = 1, rank = 0;
  (MPI_Comm_size)(communicator, &size);
  (MPI_Comm_rank)(communicator, &rank);
  const auto processes = static_cast<std::size_t>(size);
  partition_pieces pieces({}, {});
  std::vector<std::vector<slice_piece>> nodes(processes);
  on_all(communicator, [&] {
    pieces = partition_pieces(graph_within(g), part);
    for (std::size_t k = 0; k < pieces.sizes.size(); ++k) nodes[0].push_back({pieces.sizes[k], pieces.part[k]});
  });
  std::uint64_t first_piece = 0, count = pieces.sizes.size();
  (MPI_Exscan)(&count, &first_piece, 1, MPI_UINT64_T, MPI_SUM, communicator);
  std::vector<std::vector<slice_piece_edge>> edges(processes);
  edges[0] = edges_of_pieces(communicator, g, pieces, first_piece);
  nodes = all_to_all(communicator, nodes);
  edges = all_to_all(communicator, edges);
  std::vector<std::vector<int>> new_parts(processes);
  on_all(communicator, [&] {
    if (rank > 0) return;
    std::vector<int> all;
    for (const auto& of_process : nodes)
      for (const slice_piece& x : of_process) all.push_back(x.part);
    join_pieces(graph_of_pieces(nodes, edges), all, processes);
    auto next = all.begin();
    for (std::size_t r = 0; r < processes; ++r) {
      const auto end = next + static_cast<std::ptrdiff_t>(nodes[r].size());
      new_parts[r].assign(next, end);
      next = end;
    }
  });
  new_parts = all_to_all(communicator, new_parts);
  for (std::size_t i = 0; i < part.size(); ++i) part[i] = new_parts[0][pieces.piece_of[i]];
}

}  // namespace concino::detail
