// Finds pairs of segments on a lattice that may meet.
#pragma once

#include <concino/core/box_tree_builder.hpp>
#include <concino/core/vec3.hpp>
#include <concino/print/polygon_clipper.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace concino::detail {

using lattice_segment = std::array<snapped_point, 2>;

/// A tree of the boxes of segments, which reach one unit beyond their ends.
class segment_tree {
  struct node {
    std::uint32_t first = 0, count = 0;
    float min[2] = {0, 0}, max[2] = {0, 0};
  };
  std::vector<core::box_item> items_;
  std::vector<node> nodes_;

  static constexpr float infinite = std::numeric_limits<float>::infinity();
  static float below(std::int64_t x) { return std::nextafter(static_cast<float>(x - 1), -infinite); }
  static float above(std::int64_t x) { return std::nextafter(static_cast<float>(x + 1), infinite); }

  template<class A, class B>
  static bool meet(const A& a, const B& b) {
    return a.min[0] <= b.max[0] && b.min[0] <= a.max[0] && a.min[1] <= b.max[1] && b.min[1] <= a.max[1];
  }

 public:
  explicit segment_tree(const std::vector<lattice_segment>& segments) {
    items_.reserve(segments.size());
    for (std::uint32_t i = 0; i < segments.size(); ++i) {
      const auto& [a, b] = segments[i];
      items_.push_back({{below(std::min(a[0], b[0])), below(std::min(a[1], b[1])), 0},
                        {above(std::max(a[0], b[0])), above(std::max(a[1], b[1])), 0},
                        i});
    }
    nodes_ = core::box_tree_builder<node>(items_, 4)();
    for (std::size_t n = nodes_.size(); n-- > 0;) {
      node& x = nodes_[n];
      x.min[0] = x.min[1] = infinite;
      x.max[0] = x.max[1] = -infinite;
      const auto add = [&x](const auto& y) {
        for (const std::size_t k : {0u, 1u})
          x.min[k] = std::min(x.min[k], y.min[k]), x.max[k] = std::max(x.max[k], y.max[k]);
      };
      if (x.count > 0)
        for (std::uint32_t i = x.first; i < x.first + x.count; ++i) add(items_[i]);
      else add(nodes_[x.first]), add(nodes_[x.first + 1]);
    }
  }

  /// Calls visit(i, j) once for each pair of segments, i < j, whose boxes meet, until it returns false.
  template<class Visit>
  void for_each_pair(const Visit& visit) const {
    std::vector<std::uint32_t> open;
    for (const core::box_item& item : items_) {
      open.assign(nodes_.empty() ? 0 : 1, 0);
      while (!open.empty()) {
        const node& x = nodes_[open.back()];
        open.pop_back();
        if (!meet(x, item)) continue;
        if (x.count == 0) open.insert(open.end(), {x.first, x.first + 1});
        for (std::uint32_t i = x.first; i < x.first + x.count; ++i)
          if (items_[i].id > item.id && meet(items_[i], item) && !visit(item.id, items_[i].id)) return;
      }
    }
  }
};

inline vec3 as_vec3(const snapped_point& p) { return {static_cast<double>(p[0]), static_cast<double>(p[1]), 0}; }

}  // namespace concino::detail
