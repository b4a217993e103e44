// Follows components of level sets; see level_tracking.hpp.
#pragma once

#include <concino/fields/detail/topology/grouped_numbers.hpp>
#include <concino/fields/detail/topology/level_tracking.hpp>
#include <concino/fields/detail/topology/link_cut_forest.hpp>
#include <concino/graph/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>

namespace concino::detail {

/// The level set of t has a node for each edge that t crosses. A triangle abc joins its edge ac to ab below b, and to
/// bc above. These joints are kept as a spanning forest that prefers the joints that last longest, so that one that
/// ends is never replaced by another.
class level_forest {
  const level_complex& complex_;
  link_cut_forest forest_;
  std::vector<unsigned char> is_joined_;  // by triangle
  std::uint32_t edges_;

  static std::vector<std::uint32_t> initial_weights(const level_complex& c) {
    return std::vector<std::uint32_t>(c.edges.size() + c.triangles.size(), no_rank);
  }

  std::array<std::uint32_t, 2> ends(std::uint32_t triangle, bool above) const {
    return {complex_.triangles[triangle][0], complex_.triangles[triangle][above ? 2 : 1]};
  }

  void divide(std::uint32_t triangle) {
    const std::uint32_t joint = edges_ + triangle;
    for (const std::uint32_t e : ends(triangle, is_joined_[triangle] == 2)) forest_.cut(joint, e);
    is_joined_[triangle] = 0;
  }

 public:
  explicit level_forest(const level_complex& c)
      : complex_(c), forest_(initial_weights(c)), is_joined_(c.triangles.size()),
        edges_(static_cast<std::uint32_t>(c.edges.size())) {}

  void join(std::uint32_t triangle, bool above) {
    const std::uint32_t joint = edges_ + triangle,
                        until = complex_.edges[complex_.triangles[triangle][above ? 0 : 1]][1];
    const auto [a, b] = ends(triangle, above);
    const std::uint32_t lightest = forest_.lightest_between(a, b);
    if (lightest != link_cut_forest::none) {
      if (forest_.weight(lightest) >= until) return;
      divide(lightest - edges_);
    }
    forest_.set_weight(joint, until);
    is_joined_[triangle] = above ? 2 : 1;
    forest_.link(joint, a);
    forest_.link(b, joint);
  }
  void end(std::uint32_t triangle, bool above) {
    if (is_joined_[triangle] == (above ? 2 : 1)) divide(triangle);
  }
  std::uint32_t component(std::uint32_t edge) { return forest_.root(edge); }
};

CONCINO_INLINE std::vector<level_link> find_level_links(const level_complex& complex, std::uint32_t n) {
  const auto edge_count = complex.edges.size(), triangle_count = complex.triangles.size();
  const auto end_of = [&](std::size_t t, std::size_t edge, std::size_t end) {
    return complex.edges[complex.triangles[t][edge]][end];
  };
  const grouped_numbers edges_below(n, edge_count, [&](std::size_t e) { return complex.edges[e][1]; });
  const grouped_numbers edges_above(n, edge_count, [&](std::size_t e) { return complex.edges[e][0]; });
  const grouped_numbers lowest_of(n, triangle_count, [&](std::size_t t) { return end_of(t, 0, 0); });
  const grouped_numbers middle_of(n, triangle_count, [&](std::size_t t) { return end_of(t, 1, 1); });
  const grouped_numbers highest_of(n, triangle_count, [&](std::size_t t) { return end_of(t, 0, 1); });
  level_forest forest(complex);
  // the vert that a component met last, by its root
  std::vector<std::uint32_t> last(edge_count + triangle_count, no_rank);
  std::vector<std::uint32_t> below;
  std::vector<level_link> links;
  for (std::uint32_t v = 0; v < n; ++v) {
    below.clear();
    for (const std::uint32_t e : edges_below[v]) below.push_back(forest.component(e));
    std::sort(below.begin(), below.end());
    below.erase(std::unique(below.begin(), below.end()), below.end());
    for (const std::uint32_t component : below) links.push_back({last[component], v});
    for (const std::uint32_t t : middle_of[v]) forest.end(t, false);
    for (const std::uint32_t t : highest_of[v]) forest.end(t, true);
    for (const std::uint32_t t : lowest_of[v]) forest.join(t, false);
    for (const std::uint32_t t : middle_of[v]) forest.join(t, true);
    // each part of what was changed has such an edge
    for (const std::uint32_t e : edges_above[v]) last[forest.component(e)] = v;
  }
  return links;
}

/// For each vert, in the order of `sequence`, the next vert at which its set of earlier verts grows; and how many sets
/// join at each.
struct merge_tree {
  std::vector<std::uint32_t> next, degree;

  merge_tree(const grouped_numbers& earlier, const level_complex& complex, std::uint32_t n, bool from_above)
      : next(n, no_rank), degree(n) {
    disjoint_sets sets(n);
    std::vector<std::uint32_t> latest(n);  // of each set, by root
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t v = from_above ? n - 1 - k : k;
      std::size_t root = v;
      for (const std::uint32_t e : earlier[v]) {
        const std::size_t other = sets.root(complex.edges[e][from_above ? 1 : 0]);
        if (other == root) continue;
        next[latest[other]] = v;
        ++degree[v];
        root = sets.unite_roots(root, other);
      }
      latest[root] = v;
    }
  }

  /// The next vert that is not removed yet.
  std::uint32_t find_next(std::uint32_t v, const std::vector<unsigned char>& is_removed) {
    while (next[v] != no_rank && is_removed[next[v]]) next[v] = next[next[v]];
    return next[v];
  }
};

CONCINO_INLINE std::vector<level_link> merge_join_and_split_trees(const level_complex& complex, std::uint32_t n) {
  const grouped_numbers edges_below(n, complex.edges.size(), [&](std::size_t e) { return complex.edges[e][1]; });
  const grouped_numbers edges_above(n, complex.edges.size(), [&](std::size_t e) { return complex.edges[e][0]; });
  merge_tree down(edges_above, complex, n, true), up(edges_below, complex, n, false);
  std::vector<level_link> links;
  std::vector<std::uint32_t> leaves;
  std::vector<unsigned char> is_removed(n);
  for (std::uint32_t v = 0; v < n; ++v)
    if (down.degree[v] + up.degree[v] == 1) leaves.push_back(v);
  while (!leaves.empty()) {
    const std::uint32_t v = leaves.back();
    leaves.pop_back();
    if (is_removed[v]) continue;
    const bool is_upper = down.degree[v] == 0;
    merge_tree& tree = is_upper ? down : up;
    const std::uint32_t w = tree.find_next(v, is_removed);
    is_removed[v] = 1;
    if (w == no_rank) continue;  // the last vert of its component
    links.push_back({std::min(v, w), std::max(v, w)});
    if (--tree.degree[w]; down.degree[w] + up.degree[w] == 1) leaves.push_back(w);
  }
  return links;
}

CONCINO_INLINE contracted_links contract_links(const std::vector<level_link>& links, std::uint32_t n) {
  const grouped_numbers above(n, links.size(), [&](std::size_t k) { return links[k][0]; });
  std::vector<std::uint32_t> below(n);
  for (const level_link& link : links) ++below[link[1]];
  const auto is_node = [&](std::uint32_t v) { return below[v] != 1 || above[v].size() != 1; };
  contracted_links result;
  std::vector<std::uint32_t> uppers;
  for (std::uint32_t v = 0; v < n; ++v) {
    if (!is_node(v)) continue;
    result.nodes.push_back(v);
    uppers.clear();
    for (const std::uint32_t link : above[v]) uppers.push_back(links[link][1]);
    std::sort(uppers.begin(), uppers.end());
    for (std::uint32_t w : uppers) {
      const auto first = static_cast<std::uint32_t>(result.regular.size());
      for (; !is_node(w); w = links[above[w][0]][1]) result.regular.push_back(w);
      result.arcs.push_back({v, w, first, static_cast<std::uint32_t>(result.regular.size())});
    }
  }
  return result;
}

}  // namespace concino::detail
