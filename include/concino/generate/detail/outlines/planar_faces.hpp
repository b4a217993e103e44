// The bounded regions of segments and bridges in the plane, as cycles of points.
#pragma once

#include <concino/generate/planar_segments.hpp>
#include <concino/geometry/orientation.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Directed edge 2e leads from the first point of edge e to its second one, and 2e + 1 leads back. Edges are the
/// segments, then the bridges. Regions are on the left.
class planar_faces {
  const core::planar_segments& g_;
  const std::vector<std::array<std::uint32_t, 2>>& bridges_;
  std::vector<std::uint32_t> next_;           // by directed edge: the next one around its region
  std::vector<std::uint32_t> offsets_, order_;  // by point: the directed edges that leave it, counter-clockwise from
                                                // below

  std::uint32_t num_edges() const { return static_cast<std::uint32_t>(g_.segments.size() + bridges_.size()); }
  std::uint32_t from(std::uint32_t d) const {
    const std::uint32_t e = d / 2, n = static_cast<std::uint32_t>(g_.segments.size());
    return e < n ? g_.segments[e][d % 2] : bridges_[e - n][d % 2];
  }

  void order_edges() {
    const std::uint32_t n = 2 * num_edges();
    offsets_.assign(g_.points.size() + 1, 0);
    for (std::uint32_t d = 0; d < n; ++d) ++offsets_[from(d) + 1];
    for (std::size_t p = 1; p < offsets_.size(); ++p) offsets_[p] += offsets_[p - 1];
    order_.resize(n);
    std::vector<std::uint32_t> place(offsets_.begin(), offsets_.end() - 1);
    for (std::uint32_t d = 0; d < n; ++d) order_[place[from(d)]++] = d;
    for (std::uint32_t p = 0; p < g_.points.size(); ++p)
      std::sort(order_.begin() + offsets_[p], order_.begin() + offsets_[p + 1], [&](std::uint32_t a, std::uint32_t b) {
        if (a % 2 != b % 2) return a % 2 == 0;  // those that lead to the right come first
        return a != b && orient2d(g_.points[p], g_.points[from(a ^ 1)], g_.points[from(b ^ 1)]) > 0;
      });
  }

  void link_edges() {
    next_.resize(order_.size());
    for (std::size_t p = 0; p + 1 < offsets_.size(); ++p)
      for (std::uint32_t i = offsets_[p]; i < offsets_[p + 1]; ++i)
        next_[order_[i] ^ 1] = order_[(i == offsets_[p] ? offsets_[p + 1] : i) - 1];
  }

 public:
  planar_faces(const core::planar_segments& g, const std::vector<std::array<std::uint32_t, 2>>& bridges)
      : g_(g), bridges_(bridges) {
    order_edges();
    link_edges();
  }

  /// Calls visit(points, edges) for each cycle of directed edges: the points from which they lead, and the edges.
  template<class Visit>
  void for_each(Visit&& visit) const {
    std::vector<std::uint8_t> is_visited(next_.size(), 0);
    std::vector<std::uint32_t> points, edges;
    for (std::uint32_t first = 0; first < next_.size(); ++first) {
      if (is_visited[first]) continue;
      points.clear();
      edges.clear();
      for (std::uint32_t d = first; !is_visited[d]; d = next_[d]) {
        is_visited[d] = 1;
        points.push_back(from(d));
        edges.push_back(d);
      }
      visit(points, edges);
    }
  }
};

}  // namespace concino::detail
