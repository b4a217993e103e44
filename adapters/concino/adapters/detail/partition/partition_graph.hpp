// Partitions of a graph in arrays, independent of the library that computes them: pieces that are joined, and figures.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace concino::detail {

/// A graph without loops: the neighbours of node i are neighbours[offsets[i]] .. neighbours[offsets[i + 1] - 1].
struct partition_graph {
  std::vector<int> offsets = {0};
  std::vector<int> neighbours = {};
  std::vector<std::size_t> sizes = {};    // how many nodes of a finer graph each stands for; empty: 1
  std::vector<std::size_t> weights = {};  // how many of its edges each entry of neighbours stands for; empty: 1

  std::size_t size() const { return offsets.size() - 1; }
  std::size_t size_of(std::size_t i) const { return sizes.empty() ? 1 : sizes[i]; }
  /// Calls f(neighbour, weight).
  template<class F>
  void for_each_edge(std::size_t i, F f) const {
    for (auto k = static_cast<std::size_t>(offsets[i]); k < static_cast<std::size_t>(offsets[i + 1]); ++k)
      f(static_cast<std::size_t>(neighbours[k]), weights.empty() ? 1 : weights[k]);
  }
  template<class F>
  void for_each_neighbour(std::size_t i, F f) const {
    for_each_edge(i, [&](std::size_t j, std::size_t) { f(j); });
  }
};

/// The connected pieces of the parts.
struct partition_pieces {
  std::vector<std::size_t> piece_of;  // of each node
  std::vector<int> part;              // of each piece
  std::vector<std::size_t> sizes;     // of each piece: the sum of those of its nodes

  partition_pieces(const partition_graph& g, const std::vector<int>& part_of) : piece_of(g.size(), g.size()) {
    std::vector<std::size_t> stack;
    for (std::size_t first = 0; first < g.size(); ++first) {
      if (piece_of[first] != g.size()) continue;
      const std::size_t piece = sizes.size();
      part.push_back(part_of[first]);
      sizes.push_back(0);
      piece_of[first] = piece;
      for (stack.push_back(first); !stack.empty();) {
        const std::size_t i = stack.back();
        stack.pop_back();
        sizes[piece] += g.size_of(i);
        g.for_each_neighbour(i, [&](std::size_t j) {
          if (piece_of[j] != g.size() || part_of[j] != part_of[first]) return;
          piece_of[j] = piece;
          stack.push_back(j);
        });
      }
    }
  }
};

/// Joins all pieces of a part but its largest to the neighbouring part with which they share the most edges; small
/// pieces first, and those without such a neighbour later. So every part is connected if the graph is. In a graph with
/// several components, pieces of which no neighbour belongs to a largest piece keep their part.
/// Returns the number of pieces that have changed their part.
inline std::size_t join_pieces(const partition_graph& g, std::vector<int>& part_of, std::size_t parts) {
  const partition_pieces pieces(g, part_of);
  const std::size_t none = pieces.sizes.size();
  std::vector<std::size_t> largest(parts, none), waiting;
  for (std::size_t p = 0; p < none; ++p) {
    std::size_t& l = largest[static_cast<std::size_t>(pieces.part[p])];
    if (l == none || pieces.sizes[p] > pieces.sizes[l]) l = p;
  }
  std::vector<std::vector<std::size_t>> nodes(none);
  std::vector<int> new_part(none, -1);
  for (std::size_t p = 0; p < none; ++p) {
    if (largest[static_cast<std::size_t>(pieces.part[p])] == p) new_part[p] = pieces.part[p];
    else waiting.push_back(p);
  }
  if (waiting.empty()) return 0;
  for (std::size_t i = 0; i < g.size(); ++i)
    if (new_part[pieces.piece_of[i]] < 0) nodes[pieces.piece_of[i]].push_back(i);
  std::sort(waiting.begin(), waiting.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(pieces.sizes[a], a) < std::pair(pieces.sizes[b], b);
  });
  std::size_t joined = 0;
  std::vector<std::size_t> edges(parts);
  for (bool changes = true; changes && !waiting.empty();) {
    changes = false;
    std::erase_if(waiting, [&](std::size_t p) {
      std::fill(edges.begin(), edges.end(), std::size_t{0});
      for (const std::size_t i : nodes[p])
        g.for_each_edge(i, [&](std::size_t j, std::size_t weight) {
          if (const int other = new_part[pieces.piece_of[j]]; other >= 0)
            edges[static_cast<std::size_t>(other)] += weight;
        });
      const auto best = std::max_element(edges.begin(), edges.end());
      if (*best == 0) return false;
      new_part[p] = static_cast<int>(best - edges.begin());
      joined += new_part[p] != pieces.part[p];
      changes = true;
      return true;
    });
  }
  for (std::size_t i = 0; i < g.size(); ++i)
    if (const int part = new_part[pieces.piece_of[i]]; part >= 0) part_of[i] = part;
  return joined;
}

}  // namespace concino::detail
