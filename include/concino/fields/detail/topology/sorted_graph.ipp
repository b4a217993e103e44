// Sorts the verts of a graph; see sorted_graph.hpp.
#pragma once

#include <concino/fields/detail/topology/sorted_graph.hpp>

#include <algorithm>

namespace concino::detail {

CONCINO_INLINE void vert_ranks::sort(const vert_order& order) {
  struct entry {
    double value;
    std::uint32_t index;
    bool operator<(const entry& o) const { return value < o.value || (value == o.value && index < o.index); }
  };
  std::vector<entry> entries;
  entries.reserve(index.size());
  for (const std::uint32_t i : index) entries.push_back({order.value(i), i});
  std::sort(entries.begin(), entries.end());
  rank.assign(order.values().size(), no_rank);
  values.resize(entries.size());
  for (std::uint32_t r = 0; r < entries.size(); ++r) {
    values[r] = entries[r].value;
    index[r] = entries[r].index;
    rank[entries[r].index] = r;
  }
}

}  // namespace concino::detail
