// A binary tree of boxes around numbered items, in one flat array, and its two kinds of traversal. box_tree_build.hpp
// decides how items are grouped.
#pragma once

#include <concino/geometry/bounding_box.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace concino::detail {

struct box_node {
  vec3 min, max;            // of all items below
  std::uint32_t first = 0;  // an inner node's left child, which the right one follows; or a leaf's first item
  std::uint32_t count = 0;  // the number of items of a leaf; 0: an inner node

  void add(const box& b) {
    for (std::size_t k = 0; k < 3; ++k) {
      min[k] = std::min(min[k], b.min[k]);
      max[k] = std::max(max[k], b.max[k]);
    }
  }
  bool meets(const box& b) const {
    return min.x <= b.max.x && b.min.x <= max.x && min.y <= b.max.y && b.min.y <= max.y && min.z <= b.max.z &&
           b.min.z <= max.z;
  }
  bool holds(const vec3& x) const {
    return min.x <= x.x && x.x <= max.x && min.y <= x.y && x.y <= max.y && min.z <= x.z && x.z <= max.z;
  }
  bool projection_contains(const vec3& x, std::size_t k) const {
    const std::size_t i = k == 2 ? 0 : k + 1, j = k == 0 ? 2 : k - 1;
    return min[i] <= x[i] && x[i] <= max[i] && min[j] <= x[j] && x[j] <= max[j];
  }
  /// The squared distance from x; 0 if x is inside.
  double squared_distance(const vec3& x) const {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double d = std::max(std::max(min[k] - x[k], x[k] - max[k]), 0.0);
      sum += d * d;
    }
    return sum;
  }
};

/// A tree of boxes. Items are numbered in the order of the leaves.
class box_tree {
  /// Twice the depth that a tree of 2^32 items can reach.
  static constexpr std::size_t max_levels = 128;

  std::vector<box_node> nodes_;

 public:
  box_tree() = default;
  explicit box_tree(std::vector<box_node> nodes) : nodes_(std::move(nodes)) {}

  const std::vector<box_node>& nodes() const { return nodes_; }

  /// Visits, in order, the items of all leaves for which keep(node) is true on the path from the root. Ends when a
  /// visit returns true, and returns whether one did.
  template<class Keep, class Visit>
  bool walk(Keep&& keep, Visit&& visit) const {
    if (nodes_.empty() || !keep(nodes_[0])) return false;
    std::array<std::uint32_t, max_levels> later;
    std::size_t waiting = 0;
    std::uint32_t at = 0;
    while (true) {
      const box_node& n = nodes_[at];
      if (n.count == 0) {
        const bool left = keep(nodes_[n.first]), right = keep(nodes_[n.first + 1]);
        if (left && right) {
          assert(waiting < max_levels);
          later[waiting++] = n.first + 1;
        }
        if (left || right) {
          at = left ? n.first : n.first + 1;
          continue;
        }
      } else {
        for (std::uint32_t i = n.first; i < n.first + n.count; ++i)
          if (visit(i)) return true;
      }
      if (waiting == 0) return false;
      at = later[--waiting];
    }
  }

  /// Visits items, near ones first, while the lower bound of their nodes is at most `limit`, which visits may lower.
  /// Infinite bounds are skipped.
  template<class LowerBound, class Visit>
  void search(LowerBound&& lower_bound, const double& limit, Visit&& visit) const {
    constexpr double none = std::numeric_limits<double>::infinity();
    struct entry {
      std::uint32_t node;
      double bound;
    };
    if (nodes_.empty()) return;
    std::array<entry, max_levels> later;
    std::size_t waiting = 0;
    entry at{0, lower_bound(nodes_[0])};
    while (true) {
      if (at.bound < none && at.bound <= limit) {
        const box_node& n = nodes_[at.node];
        if (n.count == 0) {
          entry near{n.first, lower_bound(nodes_[n.first])}, far{n.first + 1, lower_bound(nodes_[n.first + 1])};
          if (far.bound < near.bound) std::swap(near, far);
          if (far.bound < none && far.bound <= limit) {
            assert(waiting < max_levels);
            later[waiting++] = far;
          }
          at = near;
          continue;
        }
        for (std::uint32_t i = n.first; i < n.first + n.count; ++i) visit(i);
      }
      if (waiting == 0) return;
      at = later[--waiting];
    }
  }
};

}  // namespace concino::detail
