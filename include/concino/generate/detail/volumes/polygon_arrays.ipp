// Bodies of polygon_arrays.hpp: a surface as flat arrays, with the names that its elements have in messages; and its
// orientation.
#pragma once

#include <concino/core/error.hpp>
#include <concino/generate/detail/volumes/polygon_arrays.hpp>

#include <algorithm>
#include <utility>

namespace concino::detail {

struct poly_edge {
  std::uint32_t low, high, poly;
  bool ascends;
};

/// The oriented edges of all polys, those of one edge next to each other.
inline std::vector<poly_edge> sorted_oriented_edges(const polygon_arrays& s) {
  std::vector<poly_edge> edges_of_polys;
  edges_of_polys.reserve(s.corners.size());
  for (std::uint32_t p = 0; p < s.num_polys(); ++p) {
    const std::size_t begin = s.offsets[p], end = s.offsets[p + 1];
    if (end - begin < 3)
      core::throw_joined<invalid_mesh>({"tetrahedralize: poly ", s.poly_index[p], " has fewer than 3 verts"});
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t from = s.corners[i], to = s.corners[i + 1 < end ? i + 1 : begin];
      if (from == to)
        core::throw_joined<invalid_mesh>(
            {"tetrahedralize: poly ", s.poly_index[p], " repeats vert ", s.vert_index[from]});
      edges_of_polys.push_back({std::min(from, to), std::max(from, to), p, from < to});
    }
  }
  std::sort(edges_of_polys.begin(), edges_of_polys.end(),
            [](const poly_edge& a, const poly_edge& b) { return std::pair(a.low, a.high) < std::pair(b.low, b.high); });
  for (std::size_t i = 0; i < edges_of_polys.size();) {
    std::size_t n = 1;
    while (i + n < edges_of_polys.size() && edges_of_polys[i + n].low == edges_of_polys[i].low &&
           edges_of_polys[i + n].high == edges_of_polys[i].high)
      ++n;
    if (n != 2)
      core::throw_joined<invalid_mesh>(
          {"tetrahedralize: the edge between verts ", s.vert_index[edges_of_polys[i].low], " and ",
           s.vert_index[edges_of_polys[i].high], " of poly ", s.poly_index[edges_of_polys[i].poly],
           n == 1 ? " has no other poly; the surface must be closed" : " has more than two polys"});
    i += n;
  }
  return edges_of_polys;
}

CONCINO_INLINE void orient_alike(polygon_arrays& s) {
  const std::vector<poly_edge> edges_of_polys = sorted_oriented_edges(s);
  // by poly: its pairs of oriented edges
  std::vector<std::uint32_t> first(s.num_polys() + 1, 0), pairs(edges_of_polys.size());
  for (const poly_edge& d : edges_of_polys) ++first[d.poly + 1];
  for (std::size_t p = 0; p < s.num_polys(); ++p) first[p + 1] += first[p];
  std::vector<std::uint32_t> next = first;
  for (std::uint32_t i = 0; i < edges_of_polys.size(); ++i) pairs[next[edges_of_polys[i].poly]++] = i / 2;
  enum : unsigned char { unseen, kept, reversed };
  std::vector<unsigned char> state(s.num_polys(), unseen);
  std::vector<std::uint32_t> part;
  for (std::uint32_t seed = 0; seed < s.num_polys(); ++seed) {
    if (state[seed] != unseen) continue;
    part.assign(1, seed);
    state[seed] = kept;
    bool changed = false;
    for (std::size_t k = 0; k < part.size(); ++k)
      for (std::uint32_t i = first[part[k]]; i < first[part[k] + 1]; ++i) {
        const poly_edge &a = edges_of_polys[2 * pairs[i]], &b = edges_of_polys[2 * pairs[i] + 1];
        const std::uint32_t p = part[k], q = a.poly == p ? b.poly : a.poly;
        const unsigned char wanted = (a.ascends != b.ascends) == (state[p] == kept) ? kept : reversed;
        if (state[q] == unseen) {
          state[q] = wanted;
          changed = changed || wanted == reversed;
          part.push_back(q);
        } else if (state[q] != wanted) {
          core::throw_joined<invalid_mesh>({"tetrahedralize: the surface has only one side: polys ", s.poly_index[p],
                                            " and ", s.poly_index[q], " cannot be oriented alike with all others"});
        }
      }
    if (!changed) continue;
    double volume = 0;
    const vec3 origin = s.points[s.corners[s.offsets[seed]]];
    for (const std::uint32_t p : part)
      for (std::size_t i = s.offsets[p] + 1; i + 1 < s.offsets[p + 1]; ++i) {
        const vec3 a = s.points[s.corners[s.offsets[p]]] - origin, b = s.points[s.corners[i]] - origin,
                   c = s.points[s.corners[i + 1]] - origin;
        volume += (state[p] == kept ? 1 : -1) * dot(a, cross(b, c));
      }
    for (const std::uint32_t p : part)
      if ((state[p] == reversed) == (volume >= 0))
        std::reverse(s.corners.begin() + static_cast<std::ptrdiff_t>(s.offsets[p]),
                     s.corners.begin() + static_cast<std::ptrdiff_t>(s.offsets[p + 1]));
  }
}

}  // namespace concino::detail
