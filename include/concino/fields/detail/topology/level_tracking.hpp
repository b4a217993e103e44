// Follows the components of level sets from vert to vert, and joins what lies between branchings into arcs.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/fields/detail/topology/level_complex.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Two ranks, the lower first: the verts at the lower and the upper end of a component of level sets that meets no vert
/// between them.
using level_link = std::array<std::uint32_t, 2>;

/// The links of the Reeb graph of a complex with n verts.
/// Source: Parsa 2013, "A deterministic O(m log m) time algorithm for the Reeb graph".
std::vector<level_link> find_level_links(const level_complex& complex, std::uint32_t n);

/// The same if the graph has no loops, from the joins of sets above and below values.
/// Source: Carr, Snoeyink, Axen 2003, "Computing contour trees in all dimensions".
std::vector<level_link> merge_join_and_split_trees(const level_complex& complex, std::uint32_t n);

struct contracted_links {
  struct arc {
    std::uint32_t lower, upper;  // ranks
    std::uint32_t first, last;   // in regular
  };
  std::vector<std::uint32_t> nodes;  // ranks, ascending
  std::vector<arc> arcs;             // by their lower ends
  std::vector<std::uint32_t> regular;
};

/// Nodes are the verts that do not have one link upwards and one downwards. The others belong to arcs.
contracted_links contract_links(const std::vector<level_link>& links, std::uint32_t n);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/fields/detail/topology/level_tracking.ipp>
#endif
