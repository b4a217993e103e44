// Numbers edges of a mesh in the order in which they come, in a time that does not depend on the number of edges of the mesh.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/flat_array.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

template<class M>
class crossed_edge_numbers {
  core::flat_array<std::uint32_t> number_;  // by index of the edge; its pages are touched only where edges are
  std::vector<std::uint64_t> known_;        // a bit for each index
  std::vector<std::uint32_t> others_;       // numbers of other things, ascending

 public:
  std::vector<edge_t<M>> edges;  // by number

  explicit crossed_edge_numbers(std::size_t bound) : number_(bound), known_((bound + 63) / 64) {}

  std::uint32_t add(const M& m, const edge_t<M>& e) {
    const std::size_t i = index_of(m, e);
    std::uint64_t& bits = known_[i / 64];
    const std::uint64_t bit = std::uint64_t{1} << i % 64;
    if (!(bits & bit)) {
      bits |= bit;
      number_[i] = static_cast<std::uint32_t>(edges.size());
      edges.push_back(e);
    }
    return number_[i];
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
