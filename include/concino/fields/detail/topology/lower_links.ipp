// Cycles of polyhedra with more than two at a face; see lower_links.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/fields/detail/topology/lower_links.hpp>

#include <algorithm>
#include <iterator>
#include <span>
#include <tuple>

namespace concino::detail {

/// The dimension of the kernel of the boundary modulo 2 of the polyhedra of one vert: each column, the ascending faces
/// of a poly, is reduced by the earlier ones.
CONCINO_INLINE std::uint32_t count_cycles_of_vert(std::span<const lower_face> incidences) {
  std::vector<std::vector<std::uint32_t>> columns;
  std::vector<std::uint32_t> column, sum;
  std::uint32_t cycles = 0;
  for (std::size_t i = 0; i < incidences.size();) {
    column.clear();
    for (const std::uint32_t poly = incidences[i].poly; i < incidences.size() && incidences[i].poly == poly; ++i)
      column.push_back(incidences[i].face);
    for (const auto& earlier : columns) {  // each is without the last faces of those before it
      if (!std::binary_search(column.begin(), column.end(), earlier.back())) continue;
      sum.clear();
      std::set_symmetric_difference(column.begin(), column.end(), earlier.begin(), earlier.end(),
                                    std::back_inserter(sum));
      column.swap(sum);
    }
    if (column.empty()) ++cycles;
    else columns.push_back(column);
  }
  return cycles;
}

CONCINO_INLINE void count_cycles(std::vector<lower_face> incidences, std::vector<std::uint32_t>& cycles) {
  std::sort(incidences.begin(), incidences.end(), [](const lower_face& a, const lower_face& b) {
    return std::tie(a.vert, a.poly, a.face) < std::tie(b.vert, b.poly, b.face);
  });
  for (std::size_t i = 0; i < incidences.size();) {
    std::size_t end = i;
    while (end < incidences.size() && incidences[end].vert == incidences[i].vert) ++end;
    cycles[incidences[i].vert] += count_cycles_of_vert({incidences.data() + i, end - i});
    i = end;
  }
}

[[noreturn, gnu::noinline, gnu::cold]] CONCINO_INLINE void throw_not_closed_below(std::size_t vert) {
  core::throw_joined<invalid_mesh>({"critical_points: a poly whose highest vert is vert ", vert,
                                    " has faces that are not closed around it; validate() lists such polys"});
}

}  // namespace concino::detail
