// Equivalence classes of the corners at each vert of a surface: corners connected through edges that are not cut.
// Cutting makes one vert of each class.
#pragma once

#include <concino/concepts/oriented_edges.hpp>
#include <concino/graph/disjoint_sets.hpp>

#include <limits>

namespace concino::detail {

/// Corner i of a poly, in the order of adj_p2v, has the number first[index of the poly] + i. Two corners of a vert are
/// in one class if they are connected around the vert through edges e for which is_cut(index of e) is false. Nearly
/// linear time.
template<SurfaceMesh M>
struct corner_classes {
  std::vector<std::size_t> first;
  disjoint_sets classes;

  template<class IsCut>
  corner_classes(const M& m, const IsCut& is_cut)
      : first(poly_index_bound(m)), classes(number_corners(m, first)) {
    std::vector<corner_pair> known(edge_index_bound(m));
    for (const poly_t<M> p : polys(m)) {
      const std::size_t start = first[index_of(m, p)], end = start + num_elements(adj_p2v(m, p));
      std::size_t next = start;
      for (const auto& [e, from, to] : oriented_edges(m, p)) {
        const std::size_t slot = index_of(m, e);
        std::size_t i = next++;
        if (is_cut(slot)) continue;
        std::size_t j = next == end ? start : next;
        if (index_of(m, from) > index_of(m, to)) std::swap(i, j);
        corner_pair& there = known[slot];
        if (there.low == unknown) {
          there = {i, j};
          continue;
        }
        classes.unite(there.low, i);
        classes.unite(there.high, j);
      }
    }
  }

 private:
  static constexpr std::size_t unknown = std::numeric_limits<std::size_t>::max();
  struct corner_pair {  // the corners of the first poly at an edge, at its vert of lower and of higher index
    std::size_t low = unknown, high = unknown;
  };

  static std::size_t number_corners(const M& m, std::vector<std::size_t>& first) {
    std::size_t n = 0;
    for (const poly_t<M> p : polys(m)) {
      first[index_of(m, p)] = n;
      for ([[maybe_unused]] const vert_t<M> v : adj_p2v(m, p)) ++n;
    }
    return n;
  }
};

}  // namespace concino::detail
