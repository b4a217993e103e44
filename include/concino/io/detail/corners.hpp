// The verts of polys and faces while they are read.
#pragma once

#include <concino/concepts/descriptors.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

inline constexpr std::uint64_t max_ids = 0xFFFFFFFEu;  // 32-bit ids, one of which means "none"

/// The first corner that a list of verts repeats, or its length: by sorting, for lists of many.
[[gnu::noinline, gnu::cold]] inline std::size_t first_repeated_of_many(const vert_id* verts, std::size_t n, std::vector<vert_id>& scratch) {
  scratch.assign(verts, verts + n);
  std::sort(scratch.begin(), scratch.end());
  if (std::adjacent_find(scratch.begin(), scratch.end()) == scratch.end()) return n;
  std::vector<std::size_t> place(n);
  for (std::size_t i = 0; i < n; ++i) place[i] = i;
  std::sort(place.begin(), place.end(), [&](std::size_t a, std::size_t b) { return verts[a] != verts[b] ? verts[a] < verts[b] : a < b; });
  std::size_t first = n;
  for (std::size_t i = 1; i < n; ++i)
    if (verts[place[i]] == verts[place[i - 1]]) first = std::min(first, place[i]);
  return first;
}

/// The same, quadratic for the few corners that polys have.
inline std::size_t first_repeated(const vert_id* verts, std::size_t n, std::vector<vert_id>& scratch) {
  if (n > 32) return first_repeated_of_many(verts, n, scratch);
  for (std::size_t i = 1; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (verts[i] == verts[j]) return i;
  return n;
}

}  // namespace concino::detail
