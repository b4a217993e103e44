// Bodies of maximum_matching.hpp: maximum matchings of graphs with at most three edges at each vertex, such as the
// triangles of a surface.
#pragma once

#include <concino/generate/detail/quads/maximum_matching.hpp>

#include <cstddef>
#include <utility>

namespace concino::detail {

CONCINO_INLINE augmenting_paths::augmenting_paths(std::span<const std::uint32_t> neighbours,
                                                  std::vector<std::uint32_t>& mate)
    : neighbours_(neighbours), mate_(mate), reached_(mate.size()), predecessor_(mate.size()), base_(mate.size()),
      passed_(mate.size()), even_(mate.size()) {}

CONCINO_INLINE void augmenting_paths::visit(std::uint32_t v, bool even) {
  reached_[v] = search_;
  base_[v] = v;
  even_[v] = even;
  if (even) queue_.push_back(v);
}

CONCINO_INLINE std::uint32_t augmenting_paths::base(std::uint32_t v) {
  while (base_[v] != v) v = base_[v] = base_[base_[v]];  // halves the way for the next time
  return v;
}

// Walks from both vertices towards the root by turns, until one walk meets the other.
CONCINO_INLINE std::uint32_t augmenting_paths::common_base(std::uint32_t v, std::uint32_t w) {
  ++walk_;
  for (;; std::swap(v, w)) {
    if (v == none) continue;
    v = base(v);
    if (passed_[v] == walk_) return v;
    passed_[v] = walk_;
    v = mate_[v] == none ? none : predecessor_[mate_[v]];
  }
}

// Adds the path from v to the base to a blossom, which the edge from v to w closes. Its odd vertices become even: paths
// reach them through that edge.
CONCINO_INLINE void augmenting_paths::contract_blossom(std::uint32_t v, std::uint32_t w, std::uint32_t base_of_both) {
  while (base(v) != base_of_both) {
    predecessor_[v] = w;
    w = mate_[v];
    if (!even_[w]) {
      even_[w] = true;
      queue_.push_back(w);
    }
    if (base_[v] == v) base_[v] = base_of_both;
    if (base_[w] == w) base_[w] = base_of_both;
    v = predecessor_[w];
  }
}

CONCINO_INLINE void augmenting_paths::augment_along(std::uint32_t last) {
  while (last != none) {
    const std::uint32_t v = predecessor_[last], next = mate_[v];
    mate_[v] = last;
    mate_[last] = v;
    last = next;
  }
}

CONCINO_INLINE bool augmenting_paths::find_path(std::uint32_t root) {
  ++search_;
  queue_.clear();
  visit(root, true);
  for (std::size_t i = 0; i < queue_.size(); ++i) {
    const std::uint32_t v = queue_[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t w = neighbours_[3 * std::size_t{v} + k];
      if (w == none || reached_[w] == left_out) continue;
      if (reached_[w] != search_) {
        visit(w, false);
        predecessor_[w] = v;
        if (mate_[w] == none) {
          augment_along(w);
          return true;
        }
        visit(mate_[w], true);
      } else if (even_[w] && base(w) != base(v)) {
        const std::uint32_t common = common_base(v, w);
        contract_blossom(v, w, common);
        contract_blossom(w, v, common);
      }
    }
  }
  for (const std::uint32_t v : queue_) {
    reached_[v] = left_out;
    if (mate_[v] != none) reached_[mate_[v]] = left_out;
  }
  return false;
}

CONCINO_INLINE void augmenting_paths::augment() {
  for (std::uint32_t v = 0; v < mate_.size(); ++v)
    if (mate_[v] == none && reached_[v] != left_out) find_path(v);
}

}  // namespace concino::detail
