// Bodies of field_indices.hpp: sums of the turns of a field, of frames and of the boundary.
#pragma once

#include <concino/directions/detail/surface/field_indices.hpp>

#include <cmath>
#include <numbers>

namespace concino::detail {

CONCINO_INLINE double turn_along_edge(const oriented_surface& s, int n, const std::vector<std::complex<double>>& value,
                                      std::uint32_t c) {
  // From one side of the edge only, so that a turn by half is one by minus half the other way.
  if (s.twin[c] < c) return -turn_along_edge(s, n, value, s.twin[c]);
  const std::uint32_t a = s.vert[c], b = s.vert[s.next[c]];
  return std::arg(value[b] * std::conj(value[a]) * std::polar(1.0, -n * s.transport(c)));
}

CONCINO_INLINE std::vector<int> indices_of_polys(const oriented_surface& s, int n,
                                                 const std::vector<std::complex<double>>& value) {
  std::vector<int> index(s.num_polys());
  for (std::size_t p = 0; p < s.num_polys(); ++p) {
    double sum = n * s.holonomy(p);
    for (std::uint32_t c = s.first[p]; c < s.first[p + 1]; ++c) sum += turn_along_edge(s, n, value, c);
    index[p] = static_cast<int>(std::lround(sum / (2 * std::numbers::pi)));
  }
  return index;
}

CONCINO_INLINE std::vector<loop_turn> turns_of_loops(const oriented_surface& s, int n,
                                                     const std::vector<std::complex<double>>& value) {
  std::vector<loop_turn> all;
  std::vector<unsigned char> is_visited(s.vert.size());
  for (std::uint32_t begin = 0; begin < s.vert.size(); ++begin) {
    if (s.twin[begin] != oriented_surface::none || is_visited[begin]) continue;
    double sum = 0;
    std::uint32_t c = begin;
    do {
      is_visited[c] = 1;
      const std::uint32_t v = s.vert[s.next[c]];
      sum -= turn_along_edge(s, n, value, c);
      // around[v] begins the next edge of the boundary, from which the fan goes to the edge of c
      std::uint32_t at = s.around[v];
      double inside = 0;
      for (; at != oriented_surface::none; at = s.counter_clockwise(at)) inside += s.angle[at];
      sum += n * (std::numbers::pi - inside);
      c = s.around[v];
    } while (c != begin);
    all.push_back({s.edge[begin], static_cast<int>(std::lround(sum / (2 * std::numbers::pi)))});
  }
  return all;
}

}  // namespace concino::detail
