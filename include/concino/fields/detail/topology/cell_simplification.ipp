// Simplifies functions on the cells of a surface; see cell_simplification.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/number_text.hpp>
#include <concino/fields/detail/topology/cell_simplification.hpp>
#include <concino/fields/detail/topology/grouped_numbers.hpp>
#include <concino/graph/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace concino::detail {

CONCINO_INLINE void check_cell_threshold(double threshold) {
  if (!(threshold > 0))
    core::throw_joined<invalid_argument>(
        {"simplified_on_cells: below is ", core::number_text(threshold), "; it must be above 0"});
}

[[noreturn, gnu::noinline, gnu::cold]] CONCINO_INLINE void throw_non_manifold_edge(std::size_t edge) {
  core::throw_joined<unsupported>({"simplified_on_cells: edge ", edge,
                                   " has more than two polys; simplified() allows it, for minima or for maxima"});
}

/// A minimum spanning forest of the verts pairs minima with edges, and a maximum one of the polys, without its edges,
/// pairs maxima with edges. Without the edges of pairs that are kept, they are two forests of trees with one extremum
/// each. The new function grows along the trees of verts from their minima, and along those of polys to their maxima;
/// it is the least one that does so and that is at most half of the threshold below the old one. Its theorem is that it
/// is at most as much above.
class cell_simplification {
  enum part : unsigned char { critical, of_verts, of_polys };

  const surface_cells& cells_;
  const std::vector<double>& values_;
  double threshold_;
  std::vector<std::uint32_t> edge_top_, poly_top_, sorted_edges_;
  std::vector<unsigned char> part_;     // of edges: the forest, or critical
  std::vector<unsigned char> is_tree_;  // of the whole spanning forest of verts
  simplified_cells result_;

  double at_edge(std::uint32_t e) const { return values_[edge_top_[e]]; }
  double at_poly(std::uint32_t p) const { return values_[poly_top_[p]]; }

  /// The least value that is at most half of the threshold below `old`, and above `below`.
  double raised(double old, double below) const {
    return std::max(old - threshold_ / 2, std::nextafter(below, std::numeric_limits<double>::infinity()));
  }

  void find_tops() {
    poly_top_.assign(cells_.polys, 0);
    for (std::uint32_t e = 0; e < edge_top_.size(); ++e) {
      edge_top_[e] = std::max(cells_.edge_verts[e][0], cells_.edge_verts[e][1]);
      for (const std::uint32_t p : cells_.edge_polys[e])
        if (p != no_rank) poly_top_[p] = std::max(poly_top_[p], edge_top_[e]);
    }
    std::iota(sorted_edges_.begin(), sorted_edges_.end(), 0u);
    std::sort(sorted_edges_.begin(), sorted_edges_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return edge_top_[a] < edge_top_[b] || (edge_top_[a] == edge_top_[b] && a < b);
    });
  }

  void pair_minima() {
    disjoint_sets sets(values_.size());
    for (const std::uint32_t e : sorted_edges_) {
      const std::size_t a = sets.root(cells_.edge_verts[e][0]), b = sets.root(cells_.edge_verts[e][1]);
      if (a == b) continue;
      is_tree_[e] = 1;
      if (at_edge(e) - values_[std::max(a, b)] < threshold_) part_[e] = of_verts;
      sets.unite_roots(a, b);
    }
  }

  void pair_maxima() {
    std::vector<std::uint32_t> by_descending_value(cells_.polys), place(cells_.polys);
    std::iota(by_descending_value.begin(), by_descending_value.end(), 0u);
    std::sort(by_descending_value.begin(), by_descending_value.end(), [&](std::uint32_t a, std::uint32_t b) {
      return poly_top_[a] > poly_top_[b] || (poly_top_[a] == poly_top_[b] && a > b);
    });
    for (std::uint32_t k = 0; k < by_descending_value.size(); ++k) place[by_descending_value[k]] = k + 1;
    disjoint_sets sets(cells_.polys + 1);  // 0 is what lies beyond the boundary, higher than all
    for (std::size_t k = sorted_edges_.size(); k-- > 0;) {
      const std::uint32_t e = sorted_edges_[k];
      const auto [p, q] = cells_.edge_polys[e];
      if (is_tree_[e] || p == no_rank) continue;
      const std::size_t a = sets.root(place[p]), b = q == no_rank ? sets.root(0) : sets.root(place[q]);
      if (a == b) continue;
      if (at_poly(by_descending_value[std::max(a, b) - 1]) - at_edge(e) < threshold_) part_[e] = of_polys;
      sets.unite_roots(a, b);
    }
  }

  std::uint32_t other_end(std::uint32_t e, std::uint32_t v) const {
    return cells_.edge_verts[e][0] == v ? cells_.edge_verts[e][1] : cells_.edge_verts[e][0];
  }
  std::uint32_t other_poly(std::uint32_t e, std::uint32_t p) const {
    return cells_.edge_polys[e][0] == p ? cells_.edge_polys[e][1] : cells_.edge_polys[e][0];
  }
  double highest_end(std::uint32_t e) const {
    return std::max(result_.verts[cells_.edge_verts[e][0]], result_.verts[cells_.edge_verts[e][1]]);
  }

  /// From the lowest vert of each tree on.
  void raise_verts() {
    const grouped_numbers ends(values_.size(), 2 * edge_top_.size(),
                               [&](std::size_t k) { return cells_.edge_verts[k / 2][k % 2]; });
    std::vector<unsigned char> is_visited(values_.size());
    std::vector<std::uint32_t> waiting;
    for (std::uint32_t root = 0; root < values_.size(); ++root) {
      if (is_visited[root]) continue;
      ++result_.critical[0];
      is_visited[root] = 1;
      result_.verts[root] = values_[root] - threshold_ / 2;
      for (waiting.push_back(root); !waiting.empty();) {
        const std::uint32_t v = waiting.back();
        waiting.pop_back();
        for (const std::uint32_t end : ends[v]) {
          const std::uint32_t e = end / 2, w = other_end(e, v);
          if (part_[e] != of_verts || is_visited[w]) continue;
          is_visited[w] = 1;
          result_.edges[e] = raised(at_edge(e), result_.verts[v]);
          result_.verts[w] = raised(values_[w], result_.edges[e]);
          waiting.push_back(w);
        }
      }
    }
    for (std::uint32_t e = 0; e < edge_top_.size(); ++e) {
      if (part_[e] != critical) continue;
      ++result_.critical[1];
      result_.edges[e] = raised(at_edge(e), highest_end(e));
    }
  }

  /// To the highest poly of each tree, or to the boundary.
  void raise_polys() {
    const grouped_numbers sides(cells_.polys + 1, 2 * edge_top_.size(), [&](std::size_t k) {
      return std::min<std::size_t>(cells_.edge_polys[k / 2][k % 2], cells_.polys);
    });
    std::vector<std::uint32_t> parent(cells_.polys, no_rank), order;
    std::vector<unsigned char> is_visited(cells_.polys);
    const auto add_descendants = [&](std::size_t from) {
      for (std::size_t k = from; k < order.size(); ++k)
        for (const std::uint32_t side : sides[order[k]]) {
          const std::uint32_t e = side / 2, q = other_poly(e, order[k]);
          if (part_[e] != of_polys || q == no_rank || is_visited[q]) continue;
          is_visited[q] = 1;
          parent[q] = e;
          order.push_back(q);
        }
    };
    for (std::uint32_t e = 0; e < edge_top_.size(); ++e) {  // trees that end at the boundary
      if (part_[e] != of_polys || cells_.edge_polys[e][1] != no_rank) continue;
      const std::uint32_t p = cells_.edge_polys[e][0];
      is_visited[p] = 1;
      parent[p] = e;
      order.push_back(p);
    }
    add_descendants(0);
    std::vector<std::uint32_t> by_descending_value(cells_.polys);
    std::iota(by_descending_value.begin(), by_descending_value.end(), 0u);
    std::sort(by_descending_value.begin(), by_descending_value.end(), [&](std::uint32_t a, std::uint32_t b) {
      return poly_top_[a] > poly_top_[b] || (poly_top_[a] == poly_top_[b] && a > b);
    });
    for (const std::uint32_t root : by_descending_value) {
      if (is_visited[root]) continue;
      ++result_.critical[2];
      is_visited[root] = 1;
      const std::size_t from = order.size();
      order.push_back(root);
      add_descendants(from);
    }
    for (std::size_t k = order.size(); k-- > 0;) {
      const std::uint32_t p = order[k], e = parent[p];
      double below = -std::numeric_limits<double>::infinity();
      for (const std::uint32_t side : sides[p])
        if (side / 2 != e) below = std::max(below, result_.edges[side / 2]);
      result_.polys[p] = raised(at_poly(p), below);
      if (e != no_rank) result_.edges[e] = raised(at_edge(e), std::max(highest_end(e), result_.polys[p]));
    }
  }

 public:
  cell_simplification(const surface_cells& cells, const std::vector<double>& values, double threshold)
      : cells_(cells), values_(values), threshold_(threshold), edge_top_(cells.edge_verts.size()),
        sorted_edges_(edge_top_.size()), part_(edge_top_.size()),
        is_tree_(edge_top_.size()), result_{std::vector<double>(values.size()),
                                            std::vector<double>(edge_top_.size()),
                                            std::vector<double>(cells.polys),
                                            {}} {}

  simplified_cells run() {
    find_tops();
    pair_minima();
    pair_maxima();
    raise_verts();
    raise_polys();
    return std::move(result_);
  }
};

CONCINO_INLINE simplified_cells simplify_cells(const surface_cells& cells, const std::vector<double>& values,
                                               double threshold) {
  return cell_simplification(cells, values, threshold).run();
}

}  // namespace concino::detail
