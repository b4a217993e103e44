// end_verts(m, e): the two ends of an edge as a pair with named members.
#pragma once

#include <concino/concepts/mesh.hpp>

namespace concino {

/// The ends of an edge: auto [a, b] = end_verts(m, e);
template<class Vert>
struct edge_ends {
  Vert first, second;
  friend constexpr bool operator==(const edge_ends& a, const edge_ends& b) {
    return a.first == b.first && a.second == b.second;
  }
};

/// The two verts that e joins.
/// Needs:  adj_e2v; e is an edge of m.
/// Result: first and second as adj_e2v lists them, in the same order each time.      Cost: that of adj_e2v.
/// Errors: those of adj_e2v.
inline constexpr struct end_verts_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requirement::has_adj_e2v<M>
  constexpr edge_ends<vert_t<M>> operator()(const M& m, edge_t<M> e) const {
    const auto& ends = adj_e2v(m, e);
    auto it = ends.begin();
    const vert_t<M> first = *it;
    ++it;
    return {first, *it};
  }
} end_verts{};

}  // namespace concino
