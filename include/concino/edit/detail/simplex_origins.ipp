// The origins of elements that an edit makes; see simplex_origins.hpp.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/edit/detail/simplex_origins.hpp>

#include <cmath>

namespace concino::detail {

CONCINO_INLINE double simplex_measure(const vec3* corners, unsigned size) {
  const vec3 a = corners[1] - corners[0], b = corners[2] - corners[0];
  const vec3 normal{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  if (size == 3) return 0.5 * std::sqrt(normal.x * normal.x + normal.y * normal.y + normal.z * normal.z);
  const vec3 c = corners[3] - corners[0];
  return std::abs(normal.x * c.x + normal.y * c.y + normal.z * c.z) / 6;
}

CONCINO_INLINE void find_origins(const edit_outline& e, const simplex_key& key, const std::vector<simplex_key>& old,
                                 core::small_array<origin, 4>& found) {
  simplex_key wanted = key;
  double weight = 1;
  if (key.has(edit_outline::added)) {  // the old one whose verts are those of the key and those around the new vert
    wanted = {};
    for (unsigned i = 0; i < key.n; ++i)
      if (key.v[i] != edit_outline::added) wanted.add(key.v[i]);
    for (const origin& x : e.around) {
      if (!wanted.has(x.index)) weight = x.weight;
      wanted.add(x.index);
    }
    if (wanted.n != key.n) return;
  }
  for (std::size_t i = 0; i < old.size(); ++i) {
    simplex_key now;
    for (unsigned k = 0; k < old[i].n; ++k) now.add(old[i].v[k] == e.removed ? e.remaining : old[i].v[k]);
    if (now == wanted) found.push_back({static_cast<std::uint32_t>(i), weight});
  }
}

CONCINO_INLINE element_origins poly_origins(const edit_outline& e, const std::size_t* old_index, bool sums) {
  std::vector<std::vector<origin>> lists(e.num_new);
  std::vector<unsigned char> has_successor(e.num_old, 0);
  for (unsigned k = 0; k < e.num_new; ++k)
    for (unsigned o = e.origins[k].first; o < e.origins[k].first + e.origins[k].count; ++o) {
      const double weight = e.new_measures[k] * (e.origins[k].count > 1 ? e.old_measures[o] : 1);
      lists[k].push_back({static_cast<std::uint32_t>(old_index[o]), std::isfinite(weight) ? weight : 1});
      has_successor[o] = 1;
    }
  for (unsigned o = 0; sums && o < e.num_old && e.num_new > 0; ++o) {
    if (has_successor[o]) continue;
    unsigned to = 0, most = 0;
    for (unsigned k = 0; k < e.num_new; ++k) {
      unsigned common = 0;
      for (unsigned i = 0; i < e.size; ++i)
        for (unsigned j = 0; j < e.size; ++j) common += e.old_corners[o * e.size + i] == e.new_corners[k * e.size + j];
      if (common > most) most = common, to = k;
    }
    lists[to].push_back({static_cast<std::uint32_t>(old_index[o]), 1});
  }
  element_origins all;
  for (const auto& list : lists) all.add(std::span<const origin>(list));
  return all;
}

CONCINO_INLINE element_origins corner_origins(const edit_outline& e, const std::size_t* first_corner) {
  element_origins all;
  std::vector<origin> found;
  const auto find = [&](unsigned first, unsigned last, unsigned vert, double weight) {
    for (unsigned o = first; o < last; ++o)
      for (unsigned j = 0; j < e.size; ++j)
        if (e.old_corners[o * e.size + j] == vert)
          found.push_back({static_cast<std::uint32_t>(first_corner[o] + j), weight});
  };
  for (unsigned k = 0; k < e.num_new; ++k) {
    const unsigned first = e.origins[k].first, last = first + e.origins[k].count;
    for (unsigned i = 0; i < e.size; ++i) {
      const unsigned v = e.new_corners[k * e.size + i];
      found.clear();
      find(first, last, v, 1);
      if (v == edit_outline::added)
        for (const origin& x : e.around) find(first, last, x.index, x.weight);
      if (v == e.remaining && found.empty()) find(first, last, e.removed, 1);
      if (found.empty()) find(0, e.num_old, v, 1);
      all.add(std::span<const origin>(found));
    }
  }
  return all;
}

}  // namespace concino::detail
