// Maximum matchings of graphs with at most three edges at each vertex, such as the triangles of a surface.
#pragma once

#include <concino/core/compiled.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// Finds paths that add an edge to a matching. Vertex v has the neighbours neighbours[3 v] to neighbours[3 v + 2],
/// `none` where it has fewer; mate[v] is the vertex that it is matched with, or `none`.
class augmenting_paths {
 public:
  static constexpr std::uint32_t none = ~0u;

  augmenting_paths(std::span<const std::uint32_t> neighbours, std::vector<std::uint32_t>& mate);

  /// Changes the matching along paths until it has as many edges as possible. Matched vertices stay matched.
  /// Source: Edmonds 1965, "Paths, trees, and flowers". Searches are breadth-first, so most of them stay near an
  ///         unmatched vertex. The vertices that a search without success reaches are on no later path, and are left
  ///         out. The class of Boost.Graph is not used: it searches depth-first, and its recursion along a path of 10^5
  ///         vertices overflows the stack.
  void augment();

 private:
  static constexpr std::uint32_t left_out = none;

  std::span<const std::uint32_t> neighbours_;
  std::vector<std::uint32_t>& mate_;
  std::vector<std::uint32_t> reached_;  // the number of the last search that reached a vertex. The other arrays have
                                        // values for vertices of the current search
  std::vector<std::uint32_t> predecessor_;  // of an odd vertex, and of those in blossoms: the vertex from which a
                                            // path continues to it
  std::vector<std::uint32_t> base_;     // towards the base of the blossom
  std::vector<std::uint32_t> passed_;   // the number of the last walk to a common base that passed a vertex
  std::vector<std::uint8_t> even_;      // whether a path of even length leads to the vertex
  std::vector<std::uint32_t> queue_;    // the even vertices
  std::uint32_t search_ = 0, walk_ = 0;

  void visit(std::uint32_t v, bool even);
  std::uint32_t base(std::uint32_t v);
  std::uint32_t common_base(std::uint32_t v, std::uint32_t w);
  void contract_blossom(std::uint32_t v, std::uint32_t w, std::uint32_t base);
  void augment_along(std::uint32_t last);
  bool find_path(std::uint32_t root);
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/generate/detail/quads/maximum_matching.ipp>
#endif
