// Finds pairs of items of a tree whose leaves have intersecting boxes, by traversing the tree against itself.
#pragma once

#include <concino/core/parallel.hpp>
#include <concino/geometry/detail/box_tree.hpp>

#include <array>
#include <vector>

namespace concino::detail {

class box_pairs {
  using node_pair = std::array<std::uint32_t, 2>;  // the same node twice: all pairs within it

  const std::vector<box_node>& nodes_;

  static box box_of(const box_node& n) {
    box b;
    b.min = n.min;
    b.max = n.max;
    return b;
  }
  /// Adds the pairs of children of a pair that is not of two leaves; deeper pairs first, so that few are pending.
  void split(const node_pair& p, std::vector<node_pair>& later) const {
    const box_node &a = nodes_[p[0]], &b = nodes_[p[1]];
    const auto add = [&](std::uint32_t x, std::uint32_t y) {
      if (x == y || nodes_[x].meets(box_of(nodes_[y]))) later.push_back({x, y});
    };
    if (p[0] == p[1]) {
      add(a.first, a.first + 1);
      add(a.first + 1, a.first + 1);
      add(a.first, a.first);
    } else if (b.count != 0 || (a.count == 0 && norm(a.max - a.min) >= norm(b.max - b.min))) {
      add(a.first + 1, p[1]);
      add(a.first, p[1]);
    } else {
      add(p[0], b.first + 1);
      add(p[0], b.first);
    }
  }
  bool is_of_leaves(const node_pair& p) const { return nodes_[p[0]].count != 0 && nodes_[p[1]].count != 0; }

 public:
  explicit box_pairs(const box_tree& tree) : nodes_(tree.nodes()) {}

  /// Calls visit(part, i, j) once for each pair i, j of different items, in parallel for different parts, which are 0
  /// to parts - 1. Calls prepare(parts) first.
  template<class Prepare, class Visit>
  void for_each(Prepare&& prepare, Visit&& visit) const {
    std::vector<node_pair> start, next;
    if (!nodes_.empty()) start.push_back({0, 0});
    for (bool growing = true; growing && start.size() < 1024;) {
      growing = false;
      next.clear();
      for (const node_pair& p : start) {
        if (is_of_leaves(p)) next.push_back(p);
        else {
          split(p, next);
          growing = true;
        }
      }
      start.swap(next);
    }
    prepare(start.size());
    parallel_for(start.size(), [&](std::size_t part) {
      std::vector<node_pair> later{start[part]};
      while (!later.empty()) {
        const node_pair p = later.back();
        later.pop_back();
        if (!is_of_leaves(p)) {
          split(p, later);
          continue;
        }
        const box_node &a = nodes_[p[0]], &b = nodes_[p[1]];
        for (std::uint32_t i = a.first; i < a.first + a.count; ++i)
          for (std::uint32_t j = p[0] == p[1] ? i + 1 : b.first; j < b.first + b.count; ++j) visit(part, i, j);
      }
    }, 1);
  }
};

}  // namespace concino::detail
