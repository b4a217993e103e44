// indexed_heap: the priority queue of shortest paths. Nodes are ordered by distance, each occurs at most once, and the
// distance of a waiting node may decrease.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace concino::core {

/// A heap of four children per entry that stores the position of each node. The caller owns the keys, by slot (+inf:
/// not reached yet), so that the final keys are the result. Removing the minimum moves the hole down to a leaf before
/// the last entry fills it, which takes fewer comparisons than moving that entry down from the top.
template<class Node>
class indexed_heap {
  struct entry {
    double key;
    Node node;
    std::uint32_t slot;
  };
  static constexpr std::size_t arity = 4;

  std::vector<entry> heap_;
  double* const keys_;
  const std::unique_ptr<std::uint32_t[]> positions_;  // of waiting nodes

  void put(std::size_t i, const entry& e) {
    heap_[i] = e;
    positions_[e.slot] = static_cast<std::uint32_t>(i);
  }
  void sift_up(std::size_t i, const entry& e) {
    while (i > 0) {
      const std::size_t parent = (i - 1) / arity;
      if (!(e.key < heap_[parent].key)) break;
      put(i, heap_[parent]);
      i = parent;
    }
    put(i, e);
  }

 public:
  explicit indexed_heap(std::span<double> keys) : keys_(keys.data()), positions_(new std::uint32_t[keys.size()]) {}

  bool empty() const { return heap_.empty(); }
  const Node& front() const { return heap_.front().node; }
  double min_key() const { return heap_.front().key; }
  /// The lowest distance set so far, +inf if there is none.
  double key(std::size_t slot) const { return keys_[slot]; }

  /// Needs: key < this->key(slot).
  void decrease_key(const Node& node, std::size_t slot, double key) {
    const entry e{key, node, static_cast<std::uint32_t>(slot)};
    std::size_t i = heap_.size();
    if (keys_[slot] == std::numeric_limits<double>::infinity()) heap_.push_back(e);
    else i = positions_[slot];
    keys_[slot] = key;
    sift_up(i, e);
  }

  struct popped { Node node; std::size_t slot; double key; };

  popped pop() {
    const entry top = heap_.front();
    const entry last = heap_.back();
    heap_.pop_back();
    const std::size_t n = heap_.size();
    if (n > 0) {
      std::size_t hole = 0;
      for (std::size_t first = 1; first < n; first = hole * arity + 1) {
        std::size_t best = first;
        if (first + arity <= n) {
          for (std::size_t j = 1; j < arity; ++j) best = heap_[first + j].key < heap_[best].key ? first + j : best;
        } else {
          for (std::size_t j = first + 1; j < n; ++j) best = heap_[j].key < heap_[best].key ? j : best;
        }
        put(hole, heap_[best]);
        hole = best;
      }
      sift_up(hole, last);
    }
    return {top.node, top.slot, top.key};
  }

  /// Resets the distances of the nodes that still wait, and calls forgotten(node) for each of them.
  template<class F>
  void discard_waiting(const F& forgotten) {
    for (const entry& e : heap_) {
      keys_[e.slot] = std::numeric_limits<double>::infinity();
      forgotten(e.node);
    }
    heap_.clear();
  }
};

}  // namespace concino::core
