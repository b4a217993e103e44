// See shape_clusters.hpp.
#pragma once

#include <concino/graph/detail/cuts/shape_clusters.hpp>

#include <algorithm>
#include <limits>
#include <queue>

namespace concino::detail {

class shape_lloyd {
  const shape_nodes& nodes_;
  std::vector<std::uint32_t> seeds_;  // by label
  std::vector<int> label_;            // by node, -1 for none
  std::vector<vec3> centre_;          // by label

  struct claim {
    double distance;
    std::size_t number;  // claims of equal distance are served in their order
    std::uint32_t node;
    int label;

    bool operator<(const claim& other) const {
      return distance != other.distance ? distance > other.distance : number > other.number;
    }
  };

  double distance(std::size_t node, std::size_t label) const {
    const vec3 step = nodes_.at[node] - centre_[label];
    return dot(step, step);
  }

  int nearest_label(std::size_t node) const {
    std::size_t best = 0;
    for (std::size_t l = 1; l < centre_.size(); ++l)
      if (distance(node, l) < distance(node, best)) best = l;
    return static_cast<int>(best);
  }

  /// Grows the clusters from their seeds. Nodes that no seed reaches go to the nearest centre.
  void grow() {
    std::fill(label_.begin(), label_.end(), -1);
    std::priority_queue<claim> queue;
    std::size_t number = 0;
    const auto take = [&](std::uint32_t node, int label) {
      label_[node] = label;
      for (std::size_t k = nodes_.first[node]; k < nodes_.first[node + 1]; ++k) {
        const std::uint32_t next = nodes_.neighbours[k];
        if (label_[next] < 0) queue.push({distance(next, static_cast<std::size_t>(label)), number++, next, label});
      }
    };
    for (std::size_t l = 0; l < seeds_.size(); ++l) label_[seeds_[l]] = static_cast<int>(l);
    for (std::size_t l = 0; l < seeds_.size(); ++l) take(seeds_[l], static_cast<int>(l));
    while (!queue.empty()) {
      const claim c = queue.top();
      queue.pop();
      if (label_[c.node] < 0) take(c.node, c.label);
    }
    for (std::size_t i = 0; i < label_.size(); ++i)
      if (label_[i] < 0) label_[i] = nearest_label(i);
  }

  void set_centres() {
    std::vector<double> weight(centre_.size());
    const std::vector<vec3> before = centre_;
    std::fill(centre_.begin(), centre_.end(), vec3{});
    for (std::size_t i = 0; i < label_.size(); ++i) {
      const auto l = static_cast<std::size_t>(label_[i]);
      weight[l] += nodes_.weight[i];
      centre_[l] += nodes_.weight[i] * nodes_.at[i];
    }
    for (std::size_t l = 0; l < centre_.size(); ++l) {
      const double size = nodes_.are_directions ? norm(centre_[l]) : weight[l];
      centre_[l] = size > 0 ? centre_[l] / size : before[l];
    }
  }

  /// Result: false if all seeds stay.
  bool move_seeds() {
    std::vector<double> smallest(seeds_.size());
    for (std::size_t l = 0; l < seeds_.size(); ++l) smallest[l] = distance(seeds_[l], l);
    bool has_moved = false;
    for (std::size_t i = 0; i < label_.size(); ++i) {
      const auto l = static_cast<std::size_t>(label_[i]);
      if (const double d = distance(i, l); d < smallest[l]) {
        smallest[l] = d;
        seeds_[l] = static_cast<std::uint32_t>(i);
        has_moved = true;
      }
    }
    return has_moved;
  }

 public:
  explicit shape_lloyd(const shape_nodes& nodes) : nodes_(nodes), label_(nodes.at.size()) {}

  /// Adds a cluster at the node that is farthest from its centre. Result: false if all nodes are in their centres.
  bool add_cluster() {
    std::size_t farthest = 0;
    double largest = 0;
    for (std::size_t i = 0; i < label_.size() && !centre_.empty(); ++i) {
      const double d = distance(i, static_cast<std::size_t>(label_[i]));
      if (d > largest) {
        largest = d;
        farthest = i;
      }
    }
    if (!centre_.empty() && largest == 0) return false;
    seeds_.push_back(static_cast<std::uint32_t>(farthest));
    centre_.push_back(nodes_.at[farthest]);
    grow();
    set_centres();
    return true;
  }

  /// Result: false if nothing changes any more.
  bool improve() {
    if (!move_seeds()) return false;
    grow();
    set_centres();
    return true;
  }

  shape_clusters result() const { return {label_, centre_}; }
};

CONCINO_INLINE shape_clusters find_shape_clusters(const shape_nodes& nodes, int labels, int rounds,
                                                  const progress& progress, const char* caller) {
  shape_lloyd lloyd(nodes);
  if (nodes.at.empty()) return lloyd.result();
  const double all = labels + rounds;
  int done = 0;
  const auto report = [&] { report_progress(progress, done++ / all, caller); };
  for (int l = 0; l < labels; ++l) {
    report();
    if (!lloyd.add_cluster()) break;
  }
  for (int r = 0; r < rounds; ++r) {
    report();
    if (!lloyd.improve()) break;
  }
  return lloyd.result();
}

}  // namespace concino::detail
