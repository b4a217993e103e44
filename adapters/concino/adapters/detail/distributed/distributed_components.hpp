// The components of a distributed mesh, whose polys are connected through verts, on all processes.
#pragma once

#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/detail/mpi/mpi_all_to_all.hpp>
#include <concino/adapters/distributed.hpp>
#include <concino/graph/disjoint_sets.hpp>

#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace concino::detail {

struct distributed_components {
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  std::vector<std::uint64_t> first_vert;  // of each component the lowest global number; increasing
  std::vector<std::size_t> of_vert;       // by local index; none for verts of no poly

  std::size_t size() const { return first_vert.size(); }
};

/// Of each local vert the lowest global number in its component; the largest 64-bit number for verts of no poly. Lowest
/// numbers spread through the polys of each process, and from process to process until nothing changes. Collective.
template<class M>
std::vector<std::uint64_t> component_numbers(const distributed<M>& m) {
  constexpr auto none = std::numeric_limits<std::uint64_t>::max();
  disjoint_sets sets(vert_index_bound(m));
  std::vector<std::uint64_t> label(sets.size(), none), lowest(sets.size());
  for (const poly_t<M> p : polys(m)) {
    std::size_t first = sets.size();
    for (const vert_t<M> v : adj_p2v(m, p)) {
      const std::size_t i = index_of(m, v);
      label[i] = m.global_number(v);
      if (first == sets.size()) first = i;
      else sets.unite(first, i);
    }
  }
  const ghost_exchange& exchange = m.exchange(static_cast<const vert_t<M>*>(nullptr));
  for (int changes = 1; changes;) {
    lowest = label;
    for (std::size_t i = 0; i < label.size(); ++i) lowest[sets.root(i)] = std::min(lowest[sets.root(i)], label[i]);
    for (std::size_t i = 0; i < label.size(); ++i) label[i] = lowest[sets.root(i)];
    changes = 0;
    exchange.to_owners(label.data(), [&](std::uint64_t& known, std::uint64_t other) {
      changes |= other != known;
      known = std::min(known, other);
    });
    exchange.to_ghosts(label.data());
    (MPI_Allreduce)(MPI_IN_PLACE, &changes, 1, MPI_INT, MPI_MAX, m.communicator());
  }
  return label;
}

/// Collective.
template<class M>
distributed_components find_components(const distributed<M>& m) {
  const std::vector<std::uint64_t> label = component_numbers(m);
  std::vector<std::uint64_t> own;
  for (const vert_t<M> v : verts(m))
    if (!m.is_ghost(v) && label[index_of(m, v)] == m.global_number(v)) own.push_back(m.global_number(v));
  distributed_components r;
  r.first_vert = all_from_all(m.communicator(), own);
  std::sort(r.first_vert.begin(), r.first_vert.end());
  r.of_vert.assign(label.size(), distributed_components::none);
  for (std::size_t i = 0; i < label.size(); ++i) {
    const auto at = std::lower_bound(r.first_vert.begin(), r.first_vert.end(), label[i]);
    if (at != r.first_vert.end()) r.of_vert[i] = static_cast<std::size_t>(at - r.first_vert.begin());
  }
  return r;
}

}  // namespace concino::detail
