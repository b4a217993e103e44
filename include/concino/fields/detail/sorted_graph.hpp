// The graph of the verts of a mesh in flat arrays, with the verts numbered by ascending values of a function.
#pragma once

#include <concino/concepts/primal_graph.hpp>
#include <concino/concepts/verbs.hpp>
#include <concino/core/compiled.hpp>
#include <concino/fields/detail/vert_order.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

inline constexpr std::uint32_t no_rank = 0xffffffffu;

/// The rank of a vert is the number of verts that are lower: those with smaller values, and of equal values those with smaller indices.
struct ranked_graph {
  std::vector<double> values;        // by rank, ascending
  std::vector<std::uint32_t> index;  // of the vert, by rank
  std::vector<std::uint32_t> first;  // of the neighbours, by rank, and the number of all at the end
  std::vector<std::uint32_t> neighbour_ranks;

  std::uint32_t size() const { return static_cast<std::uint32_t>(values.size()); }
  std::span<const std::uint32_t> neighbours(std::uint32_t rank) const { return {neighbour_ranks.data() + first[rank], neighbour_ranks.data() + first[rank + 1]}; }

 protected:
  /// Sorts the verts whose indices are in `index`, and returns the ranks by index.
  std::vector<std::uint32_t> sort(const vert_order& order);
};

template<PrimalGraph M>
struct sorted_graph : ranked_graph {
  std::vector<vert_t<M>> verts;  // by rank

  /// Errors: invalid_argument that names a vert whose value is not finite.
  template<class U>
  sorted_graph(const M& m, const U& u, const char* caller) {
    const vert_order order(m, u, caller);
    index.reserve(num_verts(m));
    for (const vert_t<M> v : concino::verts(m)) index.push_back(static_cast<std::uint32_t>(index_of(m, v)));
    const std::vector<std::uint32_t> rank = sort(order);
    verts.resize(index.size());
    for (const vert_t<M> v : concino::verts(m)) verts[rank[index_of(m, v)]] = v;
    first.reserve(index.size() + 1);
    first.push_back(0);
    for (const vert_t<M>& v : verts) {
      for (const vert_t<M> w : adj_v2v(m, v)) neighbour_ranks.push_back(rank[index_of(m, w)]);
      first.push_back(static_cast<std::uint32_t>(neighbour_ranks.size()));
    }
  }
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/fields/detail/sorted_graph.ipp>
#endif
