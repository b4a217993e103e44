// edge_numbers: the edges of a graph as pairs of nodes, numbered from 0.
#pragma once

#include <concino/core/message.hpp>
#include <concino/graph/detail/graph_of.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace concino::detail {

/// The edge between two nodes, with a direction. Undirected: equal to the opposite edge; directed: different from it.
/// It stores its position among the neighbours of one end, so that its number is found without a search.
template<class Node, bool Directed>
struct node_pair {
  Node source{}, target{};
  std::uint32_t slot = 0;      // among the neighbours of the source, or of the target
  bool slot_of_source = true;

  friend bool operator==(const node_pair& a, const node_pair& b) {
    if (a.source == b.source && a.target == b.target) return true;
    return !Directed && a.source == b.target && a.target == b.source;
  }
  friend bool operator!=(const node_pair& a, const node_pair& b) { return !(a == b); }
};

/// The numbers of all edges of a graph (undirected), or of all arcs, two per edge (directed).
template<bool Directed>
class edge_numbers {
  std::vector<std::size_t> first_;  // by node index: its first arc; the others follow in the order of the neighbours
  std::vector<std::size_t> table_;  // by arc: the opposite arc (directed), the number of the edge (undirected)
  std::size_t count_ = 0;

  [[noreturn]] static void throw_one_way(const std::string& word, std::size_t from, std::size_t to) {
    core::throw_joined<invalid_mesh>({"edge numbers: ", word, " ", to, " is a neighbour of ", word, " ", from,
                                ", but not the reverse; check_laws(m) describes the error"});
  }

  /// Sets table_[arc] = the opposite arc. Arcs are sorted by target. Then, for each node, its arcs are marked at their
  /// targets, which are the sources of the arcs that lead to the node.
  template<class G>
  void match_arcs(const G& g) {
    struct incoming { std::size_t from, arc; };
    std::vector<incoming> by_target(table_.size());
    std::vector<std::size_t> free(first_);
    std::vector<std::size_t> mark(g.bound(), table_.size());
    for (const typename G::node v : g.nodes()) {
      std::size_t arc = first_[g.index(v)];
      for (const typename G::node w : g.neighbours(v)) {
        std::size_t& slot = free[g.index(w)];
        if (slot == first_[g.index(w) + 1]) throw_one_way(G::element_name, g.index(v), g.index(w));
        by_target[slot++] = {g.index(v), arc++};
      }
    }
    for (const typename G::node v : g.nodes()) {
      const std::size_t i = g.index(v);
      std::size_t arc = first_[i];
      for (const typename G::node w : g.neighbours(v)) mark[g.index(w)] = arc++;
      for (std::size_t k = first_[i]; k < free[i]; ++k) {
        const auto [from, opposite] = by_target[k];
        if (mark[from] < first_[i] || mark[from] >= first_[i + 1]) throw_one_way(G::element_name, from, i);
        table_[opposite] = mark[from];
      }
    }
  }

 public:
  template<class G>
  explicit edge_numbers(const G& g) : first_(g.bound() + 1) {
    for (const typename G::node v : g.nodes())
      for ([[maybe_unused]] const typename G::node w : g.neighbours(v)) ++first_[g.index(v) + 1];
    for (std::size_t i = 0; i < g.bound(); ++i) first_[i + 1] += first_[i];
    count_ = first_.back();
    table_.resize(count_);
    match_arcs(g);
    if constexpr (!Directed) {
      // An edge has the number that its smaller arc has among the smaller arcs.
      count_ = 0;
      for (std::size_t arc = 0; arc < table_.size(); ++arc) {
        const std::size_t opposite = table_[arc];
        table_[arc] = arc < opposite ? count_++ : table_[opposite];
      }
    }
  }

  std::size_t size() const { return count_; }

  template<class G>
  std::size_t operator()(const G& g, const node_pair<typename G::node, Directed>& e) const {
    const std::size_t arc = first_[g.index(e.slot_of_source ? e.source : e.target)] + e.slot;
    if constexpr (Directed) return e.slot_of_source ? arc : table_[arc];
    else return table_[arc];
  }
};

}  // namespace concino::detail
