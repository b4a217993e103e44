// Defines triangle_complex.hpp.
#pragma once

#include <concino/skeleton/detail/triangle_complex.hpp>

#include <algorithm>
#include <iterator>
#include <limits>
#include <queue>
#include <utility>

namespace concino::detail {

CONCINO_INLINE triangle_complex::triangle_complex(std::size_t num_verts,
                                                  const std::vector<std::array<index, 3>>& triangles)
    : neighbours_(num_verts), opposite_(num_verts) {
  for (index v = 0; v < num_verts; ++v) joined_to_.push_back(v);
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const index v = t[k], a = t[(k + 1) % 3], b = t[(k + 2) % 3];
      insert_in_order(neighbours_[v], a);
      insert_in_order(neighbours_[v], b);
      insert_in_order(opposite_[v], {std::min(a, b), std::max(a, b)});
    }
}

CONCINO_INLINE bool triangle_complex::has_triangle(index a, index b) const {
  if (opposite_[b].size() < opposite_[a].size()) std::swap(a, b);
  for (const auto& e : opposite_[a])
    if (e[0] == b || e[1] == b) return true;
  return false;
}

/// Joins a to b.
CONCINO_INLINE void triangle_complex::collapse(index a, index b) {
  const auto sorted = [](index x, index y) { return std::array<index, 2>{std::min(x, y), std::max(x, y)}; };
  for (const auto& [x, y] : std::exchange(opposite_[a], {})) {
    erase_in_order(opposite_[x], sorted(a, y));
    erase_in_order(opposite_[y], sorted(a, x));
    if (x == b || y == b) continue;
    insert_in_order(opposite_[b], sorted(x, y));
    insert_in_order(opposite_[x], sorted(b, y));
    insert_in_order(opposite_[y], sorted(b, x));
  }
  for (const index w : std::exchange(neighbours_[a], {})) {
    erase_in_order(neighbours_[w], a);
    if (w == b) continue;
    insert_in_order(neighbours_[w], b);
    insert_in_order(neighbours_[b], w);
  }
  joined_to_[a] = b;
}

CONCINO_INLINE std::vector<std::array<std::uint32_t, 3>> triangle_complex::triangles() const {
  std::vector<std::array<index, 3>> all;
  for (index v = 0; v < num_verts(); ++v)
    for (const auto& [a, b] : opposite_[v])
      if (v < a) all.push_back({v, a, b});
  return all;
}

CONCINO_INLINE bool triangle_complex::is_collapsible(index a, index b) const {
  std::vector<index> both;
  std::set_intersection(neighbours_[a].begin(), neighbours_[a].end(), neighbours_[b].begin(), neighbours_[b].end(),
                        std::back_inserter(both));
  // Of a tetrahedron, the triangles behind the edge would be equal.
  return both.size() == 2 &&
         !std::binary_search(opposite_[a].begin(), opposite_[a].end(), std::array<index, 2>{both[0], both[1]});
}

CONCINO_INLINE std::uint32_t triangle_complex::split(index a, index b) {
  const auto sorted = [](index x, index y) { return std::array<index, 2>{std::min(x, y), std::max(x, y)}; };
  const auto c = static_cast<index>(num_verts());
  joined_to_.push_back(c);
  neighbours_.emplace_back();
  opposite_.emplace_back();
  const auto connect = [&](index x) {
    insert_in_order(neighbours_[c], x);
    insert_in_order(neighbours_[x], c);
  };
  const std::vector<std::array<index, 2>> of_a = opposite_[a];
  for (const auto& [x, y] : of_a) {
    if (x != b && y != b) continue;
    const index d = x == b ? y : x;
    erase_in_order(opposite_[a], sorted(b, d));
    erase_in_order(opposite_[b], sorted(a, d));
    erase_in_order(opposite_[d], sorted(a, b));
    for (const index e : {a, b}) {
      insert_in_order(opposite_[e], sorted(c, d));
      insert_in_order(opposite_[c], sorted(d, e));
      insert_in_order(opposite_[d], sorted(c, e));
    }
    connect(d);
  }
  erase_in_order(neighbours_[a], b);
  erase_in_order(neighbours_[b], a);
  connect(a);
  connect(b);
  return c;
}

CONCINO_INLINE void triangle_complex::collapse_to_curve(std::vector<vec3>& points, std::vector<double>& weights) {
  struct candidate {
    double length;
    index a, b;
    bool operator<(const candidate& o) const {  // the shortest is on top
      return length != o.length ? length > o.length : a != o.a ? a > o.a : b > o.b;
    }
  };
  std::priority_queue<candidate> queue;
  const auto push = [&](index a, index b) {
    queue.push({distance(points[a], points[b]), std::min(a, b), std::max(a, b)});
  };
  for (index v = 0; v < num_verts(); ++v)
    for (const index w : neighbours_[v])
      if (v < w) push(v, w);
  while (!queue.empty()) {
    const candidate c = queue.top();
    queue.pop();
    const bool is_current = joined_to_[c.a] == c.a && joined_to_[c.b] == c.b &&
                            std::binary_search(neighbours_[c.a].begin(), neighbours_[c.a].end(), c.b) &&
                            distance(points[c.a], points[c.b]) == c.length;
    if (!is_current || !has_triangle(c.a, c.b)) continue;
    const bool a_is_larger = neighbours_[c.a].size() > neighbours_[c.b].size();
    const index kept = a_is_larger ? c.a : c.b;
    const index other = a_is_larger ? c.b : c.a;
    collapse(other, kept);
    const double sum = weights[kept] + weights[other];
    if (sum > 0) points[kept] += (weights[other] / sum) * (points[other] - points[kept]);
    weights[kept] = sum;
    for (const index w : neighbours_[kept]) push(kept, w);
  }
}

}  // namespace concino::detail
