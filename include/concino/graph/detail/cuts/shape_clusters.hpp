// Lloyd's clustering of the nodes of a graph by a vector at each, so that each cluster is connected if it can be.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/progress.hpp>
#include <concino/core/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Nodes with their neighbours.
struct shape_nodes {
  std::vector<vec3> at;                   // by node: its unit normal, or its centre
  std::vector<double> weight;             // by node: its measure
  std::vector<std::size_t> first;         // by node: its first neighbour; one more than there are nodes
  std::vector<std::uint32_t> neighbours;  // of all nodes
  bool are_directions;                    // means of unit vectors are unit vectors again
};

struct shape_clusters {
  std::vector<int> label;    // by node
  std::vector<vec3> centre;  // by label: the mean of its nodes
};

/// Clusters grow from seeds, one node at a time: the one that is nearest to the centre of an adjacent cluster. Then the
/// node nearest to the mean of its cluster becomes the seed, until nothing changes. Clusters are added one by one, at
/// the node that is farthest from the centre of its own.
/// Source: Lloyd 1982; Cohen-Steiner, Alliez, Desbrun 2004, "Variational shape approximation".
shape_clusters find_shape_clusters(const shape_nodes& nodes, int labels, int rounds, const progress& progress,
                                   const char* caller);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/graph/detail/cuts/shape_clusters.ipp>
#endif
