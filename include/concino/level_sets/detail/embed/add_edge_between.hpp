// Lists the edge between two verts.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/mesh.hpp>

#include <vector>

namespace concino::detail {

/// Adds the edge between a and b to a list, which has room for it; nothing if there is no such edge.
template<class M>
void add_edge_between(const M& m, const vert_t<M>& a, const vert_t<M>& b, std::vector<edge_t<M>>& to) {
  for (const edge_t<M> e : adj_v2e(m, a)) {
    const auto ends = end_verts(m, e);
    if (ends.first == b || ends.second == b) return to.push_back(e);
  }
}

}  // namespace concino::detail
