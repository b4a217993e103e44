// A partition of the polys of a mesh by any library that partitions graphs.
#pragma once

#include <concino/adapters/detail/partition/partition_graph.hpp>
#include <concino/concepts/dual_graph.hpp>
#include <concino/core/error.hpp>
#include <concino/mesh/element_map.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace concino {

/// What partition returns.
template<class M>
struct partition_result {
  poly_map<M, int> part;           // of each poly: 0 to the number of parts - 1
  std::vector<std::size_t> sizes;  // of the parts, in polys; some may be 0
  double balance = 1;              // the largest size, relative to the average; 1 is perfect
  std::size_t cut = 0;             // pairs of polys across a facet that are in two parts
  std::size_t joined = 0;          // pieces of parts that were joined to a neighbouring part
};

namespace detail {

template<class M>
partition_graph partition_graph_of(const M& m) {
  std::vector<int> number(poly_index_bound(m), -1);
  int count = 0;
  for (const poly_t<M> p : polys(m)) number[index_of(m, p)] = count++;
  partition_graph g;
  g.offsets.reserve(static_cast<std::size_t>(count) + 1);
  for (const poly_t<M> p : polys(m)) {
    for (const poly_t<M> q : adj_p2p(m, p)) g.neighbours.push_back(number[index_of(m, q)]);
    if (g.neighbours.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
      throw unsupported("partition: 32-bit indices cannot count the pairs of neighbouring polys");
    g.offsets.push_back(static_cast<int>(g.neighbours.size()));
  }
  return g;
}

/// compute(graph, n) returns the part of each node, where n is at least 2 and less than the number of nodes.
template<class M, class F>
partition_result<M> partition_polys(const M& m, std::size_t n, F compute) {
  if (n == 0 || n > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw invalid_argument("partition: the number of parts must be 1 or more, and fit into an int");
  const partition_graph g = partition_graph_of(m);
  std::vector<int> part_of(g.size(), 0);
  partition_result<M> r{make_poly_map<int>(m, 0), std::vector<std::size_t>(n, 0)};
  if (n >= g.size()) {
    for (std::size_t i = 0; i < g.size(); ++i) part_of[i] = static_cast<int>(i);
  } else if (n > 1) {
    part_of = compute(g, static_cast<int>(n));
    r.joined = join_pieces(g, part_of, n);
  }
  for (std::size_t i = 0; i < g.size(); ++i) {
    ++r.sizes[static_cast<std::size_t>(part_of[i])];
    g.for_each_neighbour(i, [&](std::size_t j) { r.cut += i < j && part_of[i] != part_of[j]; });
  }
  if (g.size() > 0)
    r.balance = static_cast<double>(*std::max_element(r.sizes.begin(), r.sizes.end())) * static_cast<double>(n) /
                static_cast<double>(g.size());
  std::size_t i = 0;
  for (const poly_t<M> p : polys(m)) r.part[p] = part_of[i++];
  return r;
}

}  // namespace detail

}  // namespace concino
