// Defines curve_collapse.hpp.
#pragma once

#include <concino/skeleton/detail/curve_collapse.hpp>

#include <algorithm>
#include <limits>
#include <queue>

namespace concino::detail {

template<class T>
void insert_in_order(std::vector<T>& list, const T& x) {
  const auto place = std::lower_bound(list.begin(), list.end(), x);
  if (place == list.end() || !(*place == x)) list.insert(place, x);
}
template<class T>
void erase_in_order(std::vector<T>& list, const T& x) {
  const auto place = std::lower_bound(list.begin(), list.end(), x);
  if (place != list.end() && *place == x) list.erase(place);
}

CONCINO_INLINE curve_collapse::curve_collapse(std::vector<vec3> points, std::vector<double> weights,
                                              const std::vector<triangle>& triangles)
    : points_(std::move(points)), weights_(std::move(weights)), neighbours_(points_.size()), opposite_(points_.size()) {
  for (index v = 0; v < points_.size(); ++v) joined_to_.push_back(v);
  for (const triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const index v = t[k], a = t[(k + 1) % 3], b = t[(k + 2) % 3];
      insert_in_order(neighbours_[v], a);
      insert_in_order(neighbours_[v], b);
      insert_in_order(opposite_[v], {std::min(a, b), std::max(a, b)});
    }
}

CONCINO_INLINE bool curve_collapse::has_triangle(index a, index b) const {
  if (opposite_[b].size() < opposite_[a].size()) std::swap(a, b);
  for (const auto& e : opposite_[a])
    if (e[0] == b || e[1] == b) return true;
  return false;
}

/// Joins a to b.
CONCINO_INLINE void curve_collapse::collapse(index a, index b) {
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
  const double sum = weights_[a] + weights_[b];
  if (sum > 0) points_[b] += (weights_[a] / sum) * (points_[a] - points_[b]);
  weights_[b] = sum;
  joined_to_[a] = b;
}

CONCINO_INLINE void curve_collapse::run() {
  struct candidate {
    double length;
    index a, b;
    bool operator<(const candidate& o) const {  // the shortest is on top
      return length != o.length ? length > o.length : a != o.a ? a > o.a : b > o.b;
    }
  };
  std::priority_queue<candidate> queue;
  const auto push = [&](index a, index b) {
    queue.push({distance(points_[a], points_[b]), std::min(a, b), std::max(a, b)});
  };
  for (index v = 0; v < points_.size(); ++v)
    for (const index w : neighbours_[v])
      if (v < w) push(v, w);
  while (!queue.empty()) {
    const candidate c = queue.top();
    queue.pop();
    const bool is_current = joined_to_[c.a] == c.a && joined_to_[c.b] == c.b &&
                            std::binary_search(neighbours_[c.a].begin(), neighbours_[c.a].end(), c.b) &&
                            distance(points_[c.a], points_[c.b]) == c.length;
    if (!is_current || !has_triangle(c.a, c.b)) continue;
    const bool a_is_larger = neighbours_[c.a].size() > neighbours_[c.b].size();
    const index kept = a_is_larger ? c.a : c.b;
    collapse(a_is_larger ? c.b : c.a, kept);
    for (const index w : neighbours_[kept]) push(kept, w);
  }
}

CONCINO_INLINE curve_nodes::curve_nodes(const curve_collapse& collapse, const std::vector<vec3>& at,
                                        const std::vector<double>& weights)
    : at_(at), weights_(weights) {
  constexpr index none = static_cast<index>(-1);
  std::vector<index> node(collapse.num_verts(), none), kept;
  for (index v = 0; v < collapse.num_verts(); ++v) {
    const index r = collapse.representative(v);
    if (node[r] == none) {
      node[r] = static_cast<index>(from_.size());
      from_.emplace_back();
      kept.push_back(r);
    }
    from_[node[r]].push_back(v);
  }
  for (const index r : kept) {
    neighbours_.emplace_back();
    for (const index w : collapse.neighbours(r)) insert_in_order(neighbours_.back(), node[w]);
  }
  points_.resize(from_.size());
  radii_.resize(from_.size());
  for (index n = 0; n < from_.size(); ++n) measure(n);
}

/// The mean of the verts of a node, and their mean distance from it.
CONCINO_INLINE void curve_nodes::measure(index node) {
  double total = 0, sum = 0;
  for (const index v : from_[node]) total += weights_[v];
  const auto weight = [&](index v) {
    return total > 0 ? weights_[v] / total : 1 / static_cast<double>(from_[node].size());
  };
  vec3 mean;
  for (const index v : from_[node]) mean += weight(v) * at_[v];
  for (const index v : from_[node]) sum += weight(v) * distance(at_[v], mean);
  points_[node] = mean;
  radii_[node] = sum;
}

CONCINO_INLINE void curve_nodes::join(index a, index b) {
  for (const index w : std::exchange(neighbours_[a], {})) {
    erase_in_order(neighbours_[w], a);
    if (w == b) continue;
    insert_in_order(neighbours_[w], b);
    insert_in_order(neighbours_[b], w);
  }
  auto& all = from_[b];
  all.insert(all.end(), from_[a].begin(), from_[a].end());
  std::sort(all.begin(), all.end());
  from_[a].clear();
}

CONCINO_INLINE void curve_nodes::join_short_bones() {
  for (bool any = true; any;) {
    any = false;
    for (index leaf = 0; leaf < from_.size(); ++leaf) {
      if (from_[leaf].empty() || neighbours_[leaf].size() != 1) continue;
      std::vector<index> walk{leaf};
      index last = neighbours_[leaf][0];
      double length = distance(points_[leaf], points_[last]);
      while (neighbours_[last].size() == 2) {
        const index next = neighbours_[last][neighbours_[last][0] == walk.back()];
        walk.push_back(last);
        length += distance(points_[last], points_[next]);
        last = next;
      }
      if (neighbours_[last].size() < 3 || length >= radii_[last]) continue;
      for (const index v : walk) join(v, last);
      measure(last);
      any = true;
    }
  }
}

CONCINO_INLINE curve_nodes::graph_arrays curve_nodes::result() const {
  graph_arrays r;
  std::vector<index> number(from_.size());
  for (index n = 0; n < from_.size(); ++n) {
    if (from_[n].empty()) continue;
    number[n] = static_cast<index>(r.points.size());
    r.points.push_back(points_[n]);
    r.radii.push_back(radii_[n]);
    r.from.push_back(from_[n]);
  }
  for (index n = 0; n < from_.size(); ++n)
    for (const index w : neighbours_[n])
      if (n < w) r.edges.push_back({vert_id{number[n]}, vert_id{number[w]}});
  return r;
}

}  // namespace concino::detail
