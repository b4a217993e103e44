// A forest whose trees are joined and divided, with the lightest node of each path.
#pragma once

#include <concino/core/compiled.hpp>

#include <cstdint>
#include <vector>

namespace concino::detail {

/// Trees as sets of paths in splay trees. Nodes are numbers below size, each a tree of its own at first.
/// Needs:  numbers below size; link: nodes of different trees; cut: neighbours.
/// Cost:   O(log size) amortised a call.      Errors: none.
/// Source: Sleator, Tarjan 1983, "A data structure for dynamic trees"; 1985, "Self-adjusting binary search trees".
class link_cut_forest {
  struct node {
    std::uint32_t parent, child[2], lightest;
    bool reversed;
  };
  std::vector<node> nodes_;
  std::vector<std::uint32_t> weight_, path_;

  bool is_path_root(std::uint32_t x) const;
  void push(std::uint32_t x);
  void update(std::uint32_t x);
  void rotate(std::uint32_t x);
  void splay(std::uint32_t x);
  void expose(std::uint32_t x);
  void make_root(std::uint32_t x);

 public:
  static constexpr std::uint32_t none = 0xffffffffu;

  explicit link_cut_forest(std::vector<std::uint32_t> weights);

  void set_weight(std::uint32_t x, std::uint32_t weight);  // of a node without neighbours
  std::uint32_t weight(std::uint32_t x) const { return weight_[x]; }
  /// The root of the tree of x; link and cut change roots of the trees of their nodes only.
  std::uint32_t root(std::uint32_t x);
  /// The lightest node between a and b, these included; none if they are in different trees. It changes the root of
  /// their tree.
  std::uint32_t lightest_between(std::uint32_t a, std::uint32_t b);
  void link(std::uint32_t a, std::uint32_t b);
  void cut(std::uint32_t a, std::uint32_t b);
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/fields/detail/topology/link_cut_forest.ipp>
#endif
