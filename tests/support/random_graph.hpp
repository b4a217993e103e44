// A small graph in lists of neighbours, a model of PrimalGraph, and random ones.
#pragma once

#include <concino/concepts/primal_graph.hpp>
#include <concino/concepts/descriptors.hpp>

#include <cstddef>
#include <random>
#include <vector>

namespace concino::testing {

struct list_graph {
  std::vector<vert_id> nodes;
  std::vector<std::vector<vert_id>> neighbours;

  explicit list_graph(unsigned n) : neighbours(n) {
    for (unsigned i = 0; i < n; ++i) nodes.push_back(vert_id{i});
  }
  void add_edge(unsigned a, unsigned b) {
    neighbours[a].push_back(vert_id{b});
    neighbours[b].push_back(vert_id{a});
  }
};

/// A graph of n nodes, in which each pair is joined with a probability of `percent` in a hundred.
inline list_graph random_graph(std::mt19937& random, unsigned n, unsigned percent) {
  list_graph g(n);
  for (unsigned a = 0; a < n; ++a)
    for (unsigned b = a + 1; b < n; ++b)
      if (random() % 100 < percent) g.add_edge(a, b);
  return g;
}

}  // namespace concino::testing

template<>
struct concino::mesh_traits<concino::testing::list_graph> {
  using graph = concino::testing::list_graph;
  using vert = vert_id;
  static std::size_t num_verts(const graph& g) { return g.nodes.size(); }
  static const std::vector<vert_id>& verts(const graph& g) { return g.nodes; }
  static const std::vector<vert_id>& adj_v2v(const graph& g, vert_id v) { return g.neighbours[v.raw()]; }
  static std::size_t index_of(const graph&, vert_id v) { return v.raw(); }
  static std::size_t vert_index_bound(const graph& g) { return g.nodes.size(); }
};
static_assert(concino::PrimalGraph<concino::testing::list_graph>);
