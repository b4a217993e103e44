// Groups boxes into a binary tree from the top: each node is split to minimise the expected cost of queries (surface
// area), in time O(n log n) for any input. The trees of <concino/geometry/bounding_tree.hpp> and of
// <concino/render/box_tree_tracer.hpp> are built by it.
// Source: MacDonald and Booth 1990 for the measure (surface area heuristic); Wald 2007, "On fast construction of
//         SAH-based bounding volume
// hierarchies", for the restriction to a few split positions.
#pragma once

#include <concino/core/parallel.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace concino::core {

/// An item to sort: its box in single precision.
struct box_item {
  float min[3], max[3];
  std::uint32_t id;

  float twice_centre(std::size_t k) const { return min[k] + max[k]; }
};

/// Builds the nodes of the tree; the result is the same for any number of threads.
/// Needs:  Node: an aggregate with the members first and count, std::uint32_t, which are 0 in Node{}. Finite boxes.
template<class Node>
class box_tree_builder {
  struct extent {
    float min[3] = {inf, inf, inf}, max[3] = {-inf, -inf, -inf};
    static constexpr float inf = std::numeric_limits<float>::infinity();

    void add(const float (&low)[3], const float (&high)[3]) {
      for (std::size_t k = 0; k < 3; ++k) {
        min[k] = low[k] < min[k] ? low[k] : min[k];
        max[k] = high[k] > max[k] ? high[k] : max[k];
      }
    }
    float half_area() const {
      const float x = max[0] - min[0], y = max[1] - min[1], z = max[2] - min[2];
      return x * y + y * z + z * x;
    }
  };
  struct range {
    std::uint32_t node, first, last, level;
  };
  static constexpr std::size_t bins = 16;

  std::vector<box_item>& items_;
  std::uint32_t leaf_size_, free_levels_;

  /// Splits at the middle of the items, whatever their shapes.
  std::uint32_t halve(const range& r, std::size_t axis) const {
    const std::uint32_t middle = r.first + (r.last - r.first) / 2;
    const auto at = [&](std::uint32_t i) { return items_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(r.first), at(middle), at(r.last), [&](const box_item& a, const box_item& b) {
      const float x = a.twice_centre(axis), y = b.twice_centre(axis);
      return x < y || (x == y && a.id < b.id);
    });
    return middle;
  }

  std::uint32_t cut(const range& r) const {
    float low[3] = {extent::inf, extent::inf, extent::inf}, high[3] = {-extent::inf, -extent::inf, -extent::inf};
    for (std::uint32_t i = r.first; i < r.last; ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const float c = items_[i].twice_centre(k);
        low[k] = c < low[k] ? c : low[k];
        high[k] = c > high[k] ? c : high[k];
      }
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (high[k] - low[k] > high[axis] - low[axis]) axis = k;
    const float width = high[axis] - low[axis], scale = static_cast<float>(bins) / width;
    // very uneven splits are good for speed, but a long sequence of them would take O(n^2)
    if (!(width > 0) || !(scale < extent::inf) || r.level > free_levels_) return halve(r, axis);
    const auto bin_of = [&](const box_item& item) {
      return std::min(bins - 1, static_cast<std::size_t>((item.twice_centre(axis) - low[axis]) * scale));
    };
    extent boxes[bins];
    std::uint32_t counts[bins] = {};
    for (std::uint32_t i = r.first; i < r.last; ++i) {
      const std::size_t b = bin_of(items_[i]);
      boxes[b].add(items_[i].min, items_[i].max);
      ++counts[b];
    }
    float cost_of_right[bins];
    extent united;
    std::uint32_t count = 0;
    for (std::size_t b = bins; b-- > 1;) {
      united.add(boxes[b].min, boxes[b].max);
      count += counts[b];
      cost_of_right[b] = count > 0 ? united.half_area() * static_cast<float>(count) : 0;
    }
    united = {};
    count = 0;
    std::size_t best = 0;
    float least = extent::inf;
    for (std::size_t b = 1; b < bins; ++b) {
      united.add(boxes[b - 1].min, boxes[b - 1].max);
      count += counts[b - 1];
      if (count == 0 || count == r.last - r.first) continue;
      const float cost = united.half_area() * static_cast<float>(count) + cost_of_right[b];
      if (cost < least) {
        least = cost;
        best = b;
      }
    }
    if (best == 0 || !(least > 0)) return halve(r, axis);
    const auto begin = items_.begin();
    const auto middle =
        std::partition(begin + r.first, begin + r.last, [&](const box_item& item) { return bin_of(item) < best; });
    return static_cast<std::uint32_t>(middle - begin);
  }

  /// Builds the nodes below `r`, which itself has the index `root` and is nodes[0] here; new nodes are numbered from 1.
  template<class Small>
  void grow(std::vector<Node>& nodes, const range& r, Small&& set_aside) const {
    std::vector<range> later{r};
    while (!later.empty()) {
      const range at = later.back();
      later.pop_back();
      if (set_aside(at)) continue;
      if (at.last - at.first <= leaf_size_) {
        nodes[at.node].first = at.first;
        nodes[at.node].count = at.last - at.first;
        continue;
      }
      const std::uint32_t middle = cut(at), left = static_cast<std::uint32_t>(nodes.size());
      nodes[at.node].first = left;
      nodes.resize(nodes.size() + 2);
      later.push_back({left + 1, middle, at.last, at.level + 1});
      later.push_back({left, at.first, middle, at.level + 1});
    }
  }

 public:
  box_tree_builder(std::vector<box_item>& items, std::uint32_t leaf_size)
      : items_(items), leaf_size_(leaf_size), free_levels_(16) {
    for (std::size_t n = items.size(); n > 1; n /= 2) free_levels_ += 2;
  }

  /// The nodes, children after their parents; sorts the items by leaf. `count` of a leaf is the number of its items,
  /// and `first` the first one. `count` of an inner node is 0, and `first` its left child, which the right one follows.
  std::vector<Node> operator()() const {
    const auto n = static_cast<std::uint32_t>(items_.size());
    std::vector<Node> nodes;
    if (n == 0) return nodes;
    nodes.reserve(n);
    nodes.resize(1);
    std::vector<range> parts;
    const std::uint32_t part_size = std::max<std::uint32_t>(n / 64, 2048);
    grow(nodes, {0, 0, n, 0}, [&](const range& r) {
      const bool small = r.last - r.first <= part_size;
      if (small) parts.push_back(r);
      return small;
    });
    std::vector<std::vector<Node>> grown(parts.size());
    parallel_for(parts.size(), [&](std::size_t i) {
      grown[i].resize(1);
      grow(grown[i], {0, parts[i].first, parts[i].last, parts[i].level}, [](const range&) { return false; });
    }, 1);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const auto shift = static_cast<std::uint32_t>(nodes.size() - 1);
      for (Node& g : grown[i])
        if (g.count == 0) g.first += shift;
      nodes[parts[i].node] = grown[i][0];
      nodes.insert(nodes.end(), grown[i].begin() + 1, grown[i].end());
      grown[i] = {};
    }
    return nodes;
  }
};

}  // namespace concino::core
