// Triangulation of monotone polygons in the plane, in linear time.
#pragma once

#include <concino/generate/planar_segments.hpp>
#include <concino/geometry/orientation.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Triangulates one polygon after another.
/// Source: Garey, Johnson, Preparata, Tarjan 1978, with exact tests: no triangle is degenerate.
class monotone_polygon {
  struct corner {
    std::uint32_t point;
    bool is_upper;
  };
  std::vector<corner> order_, stack_;

  /// The corners in the order of x, then y.
  void sort_corners(const core::planar_segments& g, const std::vector<std::uint32_t>& cycle) {
    const std::size_t n = cycle.size();
    std::size_t first = 0, last = 0;
    for (std::size_t i = 1; i < n; ++i) {
      if (g.is_before(cycle[i], cycle[first])) first = i;
      if (g.is_before(cycle[last], cycle[i])) last = i;
    }
    order_.clear();
    std::size_t lower = first, upper = (first + n - 1) % n;
    while (order_.size() < n) {
      const bool take_upper = lower == last || (upper != last && g.is_before(cycle[upper], cycle[lower]));
      std::size_t& at = take_upper ? upper : lower;
      order_.push_back({cycle[at], take_upper});
      if (at == last) continue;  // at the end of its chain; the other chain meets it there
      at = take_upper ? (at + n - 1) % n : (at + 1) % n;
    }
  }

 public:
  /// Calls add(a, b, c) for each triangle of the cycle, which is counter-clockwise.
  template<class Add>
  void operator()(const core::planar_segments& g, const std::vector<std::uint32_t>& cycle, Add&& add) {
    sort_corners(g, cycle);
    stack_.assign({order_[0], order_[1]});
    for (std::size_t i = 2; i < order_.size(); ++i) {
      const corner c = order_[i];
      const auto add_with = [&](std::uint32_t a, std::uint32_t b) {
        c.is_upper ? add(b, a, c.point) : add(a, b, c.point);
      };
      corner top = stack_.back();
      if (c.is_upper != top.is_upper || i + 1 == order_.size()) {
        for (std::size_t k = 1; k < stack_.size(); ++k)
          top.is_upper ? add(stack_[k].point, stack_[k - 1].point, c.point)
                       : add(stack_[k - 1].point, stack_[k].point, c.point);
        stack_.assign({top, c});
        continue;
      }
      stack_.pop_back();
      while (!stack_.empty()) {
        const std::uint32_t a = stack_.back().point;
        if (orient2d(g.points[a], g.points[top.point], g.points[c.point]) != (c.is_upper ? -1 : 1)) break;
        add_with(a, top.point);
        top = stack_.back();
        stack_.pop_back();
      }
      stack_.push_back(top);
      stack_.push_back(c);
    }
  }
};

}  // namespace concino::detail
