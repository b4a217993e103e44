// The graph of the verts of a mesh in flat arrays, with the verts numbered by ascending values of a function.
#pragma once

#include <concino/concepts/primal_graph.hpp>
#include <concino/concepts/verbs.hpp>
#include <concino/core/compiled.hpp>
#include <concino/fields/detail/topology/vert_order.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

inline constexpr std::uint32_t no_rank = 0xffffffffu;

/// The rank of a vert is the number of verts that are lower: those with smaller values, and of equal values those with
/// smaller indices.
struct vert_ranks {
  std::vector<double> values;        // by rank, ascending
  std::vector<std::uint32_t> index;  // of the vert, by rank
  std::vector<std::uint32_t> rank;   // by index

  std::uint32_t size() const { return static_cast<std::uint32_t>(values.size()); }

 protected:
  /// Sorts the verts whose indices are in `index`.
  void sort(const vert_order& order);
};

template<class M>
struct sorted_verts : vert_ranks {
  std::vector<vert_t<M>> verts;  // by rank

  /// Errors: invalid_argument that names a vert whose value is not finite.
  template<class U>
  sorted_verts(const M& m, const U& u, const char* caller) {
    const vert_order order(m, u, caller);
    index.reserve(num_verts(m));
    for (const vert_t<M> v : concino::verts(m)) index.push_back(static_cast<std::uint32_t>(index_of(m, v)));
    sort(order);
    verts.resize(index.size());
    for (const vert_t<M> v : concino::verts(m)) verts[rank[index_of(m, v)]] = v;
  }
};

/// Neighbours of ranked verts.
struct rank_neighbours {
  std::vector<std::uint32_t> first;  // by rank, and the number of all at the end
  std::vector<std::uint32_t> all;

  std::span<const std::uint32_t> operator[](std::uint32_t rank) const {
    return {all.data() + first[rank], all.data() + first[rank + 1]};
  }
};

struct ranked_graph {
  const vert_ranks& verts;
  rank_neighbours neighbour_ranks;

  std::uint32_t size() const { return verts.size(); }
  double value(std::uint32_t rank) const { return verts.values[rank]; }
  std::span<const std::uint32_t> neighbours(std::uint32_t rank) const { return neighbour_ranks[rank]; }
};

/// The edges of the primal graph of m.
template<PrimalGraph M>
ranked_graph make_ranked_graph(const M& m, const sorted_verts<M>& sorted) {
  ranked_graph g{sorted, {}};
  g.neighbour_ranks.first.reserve(sorted.verts.size() + 1);
  g.neighbour_ranks.first.push_back(0);
  for (const vert_t<M>& v : sorted.verts) {
    for (const vert_t<M> w : adj_v2v(m, v)) g.neighbour_ranks.all.push_back(sorted.rank[index_of(m, w)]);
    g.neighbour_ranks.first.push_back(static_cast<std::uint32_t>(g.neighbour_ranks.all.size()));
  }
  return g;
}

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/fields/detail/topology/sorted_graph.ipp>
#endif
