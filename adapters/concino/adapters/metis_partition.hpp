// Divides the polys of a mesh into parts of equal size with few facets between them, by METIS: partition(m, 8, metis).
// Needs: METIS (Debian: libmetis-dev).
#pragma once

#include <concino/adapters/detail/partition/partition_polys.hpp>
#include <concino/adapters/metis.hpp>
#include <concino/concepts/views.hpp>
#include <concino/core/error.hpp>

#include <metis.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace concino {

namespace detail {

inline std::vector<int> metis_parts(const partition_graph& g, int n) {
  static_assert(sizeof(idx_t) == sizeof(int), "METIS was built with 64-bit indices");
  std::vector<int> starts = g.offsets, neighbours = g.neighbours, part(g.size());
  idx_t nodes = static_cast<idx_t>(g.size()), constraints = 1, parts = n, cut = 0, options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_NUMBERING] = 0;
  options[METIS_OPTION_SEED] = 1;
  if (neighbours.empty()) neighbours.push_back(0);  // METIS accepts no empty array
  const int code = METIS_PartGraphKway(&nodes, &constraints, starts.data(), neighbours.data(), nullptr, nullptr,
                                       nullptr, &parts, nullptr, nullptr, options, &cut, part.data());
  if (code != METIS_OK)
    throw error(code == METIS_ERROR_MEMORY ? "partition: METIS ran out of memory" : "partition: METIS failed");
  return part;
}

}  // namespace detail

/// Parts of nearly equal numbers of polys, with few pairs of neighbouring polys in different parts.
/// Needs:  DualGraph M, which outlives the result; n: the number of parts. Polys are neighbours across an edge of a
///         surface, or a face of a volume.
/// Result: see partition_result. Each part is connected across facets if the mesh is: pieces that METIS leaves beside
///         the largest of a part are joined to a neighbouring part. If n is at least the number of polys, each poly is
///         a part, and others are empty. The result is the same for every call.
/// Cost:   O(P + F) time and memory, about a microsecond per poly.
/// Errors: invalid_argument if n is 0; unsupported if 32-bit indices cannot count the pairs of neighbours; error if
///         METIS fails.
/// Source: Karypis, Kumar 1998, "Multilevel k-way partitioning scheme for irregular graphs".
template<class M>
  requires requirement::is_lvalue_or_view<M> && DualGraph<M>
partition_result<std::remove_cvref_t<M>> partition(M&& m, std::size_t n, metis_t) {
  return detail::partition_polys<std::remove_cvref_t<M>>(m, n, detail::metis_parts);
}

}  // namespace concino
