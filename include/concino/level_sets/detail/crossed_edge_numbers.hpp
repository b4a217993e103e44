// Numbers edges of a mesh in the order in which they come, in little memory: two bits for each edge of the mesh, and a number for each that comes.
#pragma once

#include <concino/concepts/mesh.hpp>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

template<class M>
class crossed_edge_numbers {
  struct word {
    std::uint64_t bits = 0;    // those of the announced edges
    std::uint32_t before = 0;  // how many are announced with smaller indices
  };

  std::vector<word> announced_;        // 64 indices each
  std::vector<std::uint32_t> number_;  // of the announced edges, by index
  std::vector<std::uint32_t> others_;  // numbers of other things, ascending

 public:
  std::vector<edge_t<M>> edges;  // by number

  explicit crossed_edge_numbers(std::size_t bound) : announced_((bound + 63) / 64) {}

  /// Announces an edge that will be added.
  void announce(std::size_t index) { announced_[index / 64].bits |= std::uint64_t{1} << index % 64; }
  /// Must follow after all were announced.
  void count() {
    std::uint32_t n = 0;
    for (word& w : announced_) {
      w.before = n;
      n += static_cast<std::uint32_t>(std::popcount(w.bits));
    }
    number_.assign(n, ~0u);
    edges.reserve(n);
  }

  std::uint32_t add(const M& m, const edge_t<M>& e) {
    const std::size_t i = index_of(m, e);
    const word& w = announced_[i / 64];
    std::uint32_t& number = number_[w.before + static_cast<std::uint32_t>(std::popcount(w.bits & ((std::uint64_t{1} << i % 64) - 1)))];
    if (number == ~0u) {
      number = static_cast<std::uint32_t>(edges.size());
      edges.push_back(e);
    }
    return number;
  }
  /// A number for something else.
  std::uint32_t add_other() {
    others_.push_back(static_cast<std::uint32_t>(edges.size()));
    edges.push_back(edge_t<M>{});
    return others_.back();
  }
  bool is_edge(std::size_t number) const { return others_.empty() || !std::binary_search(others_.begin(), others_.end(), number); }
};

}  // namespace concino::detail
