// Defines curve_nodes.hpp.
#pragma once

#include <concino/skeleton/detail/curve_nodes.hpp>

#include <algorithm>
#include <utility>

namespace concino::detail {

CONCINO_INLINE curve_nodes::curve_nodes(const triangle_complex& curve, const std::vector<vec3>& contracted,
                                        const std::vector<vec3>& at, const std::vector<double>& weights,
                                        const std::vector<medial_ball>& balls)
    : at_(at), weights_(weights), balls_(balls) {
  constexpr index none = static_cast<index>(-1);
  std::vector<index> node(curve.num_verts(), none), kept;
  for (index v = 0; v < curve.num_verts(); ++v) {
    const index r = curve.representative(v);
    if (node[r] == none) {
      node[r] = static_cast<index>(from_.size());
      from_.emplace_back();
      kept.push_back(r);
    }
    if (v < at.size()) from_[node[r]].push_back(v);
  }
  for (const index r : kept) {
    neighbours_.emplace_back();
    for (const index w : curve.neighbours(r)) insert_in_order(neighbours_.back(), node[w]);
    points_.push_back(contracted[r]);
  }
  is_joined_.resize(from_.size());
  // Nodes of new verts alone are joined to a neighbour, but no cycle is lost.
  for (index n = 0; n < from_.size(); ++n) {
    if (!from_[n].empty()) continue;
    for (const index w : neighbours_[n]) {
      bool is_in_cycle_of_3 = false;
      for (const index x : neighbours_[n])
        is_in_cycle_of_3 = is_in_cycle_of_3 || std::binary_search(neighbours_[w].begin(), neighbours_[w].end(), x);
      if (is_in_cycle_of_3) continue;
      join(n, w);
      break;
    }
  }
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
  is_joined_[a] = 1;
}

CONCINO_INLINE void curve_nodes::join_short_bones() {
  for (bool any = true; any;) {
    any = false;
    for (index leaf = 0; leaf < from_.size(); ++leaf) {
      if (neighbours_[leaf].size() != 1) continue;
      std::vector<index> walk{leaf};
      index last = neighbours_[leaf][0];
      double length = distance(points_[leaf], points_[last]);
      while (neighbours_[last].size() == 2) {
        const index next = neighbours_[last][neighbours_[last][0] == walk.back()];
        walk.push_back(last);
        length += distance(points_[last], points_[next]);
        last = next;
      }
      if (neighbours_[last].size() < 3 || length >= 1.5 * mean(last, [&](index v) { return balls_[v].radius; }))
        continue;
      for (const index v : walk) join(v, last);
      any = true;
    }
  }
}

CONCINO_INLINE curve_nodes::graph_arrays curve_nodes::result() const {
  graph_arrays r;
  std::vector<index> number(from_.size());
  for (index n = 0; n < from_.size(); ++n) {
    if (is_joined_[n]) continue;
    number[n] = static_cast<index>(r.points.size());
    r.points.push_back(points_[n]);
    r.radii.push_back(mean(n, [&](index v) { return distance(at_[v], points_[n]); }));
    r.from.push_back(from_[n]);
  }
  for (index n = 0; n < from_.size(); ++n)
    for (const index w : neighbours_[n])
      if (n < w) r.edges.push_back({vert_id{number[n]}, vert_id{number[w]}});
  return r;
}

}  // namespace concino::detail
