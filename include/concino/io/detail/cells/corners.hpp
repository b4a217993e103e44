// Checks the verts of polys and faces that are read.
#pragma once

#include <concino/concepts/descriptors.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

inline constexpr std::uint64_t max_ids = 0xFFFFFFFEu;  // 32-bit ids, one of which means "none"

/// The position of the first vert that occurs earlier in the list, or the length of the list. Sorts, for long lists.
inline std::size_t first_repeated_of_many(const vert_id* verts, std::size_t n, std::vector<std::uint64_t>& scratch) {
  scratch.clear();
  for (std::size_t i = 0; i < n; ++i) scratch.push_back(std::uint64_t{verts[i].raw()} << 32 | i);
  std::sort(scratch.data(), scratch.data() + n);
  std::size_t first = n;
  for (std::size_t i = 1; i < n; ++i)
    if (scratch[i] >> 32 == scratch[i - 1] >> 32)
      first = std::min<std::size_t>(first, static_cast<std::uint32_t>(scratch[i]));
  return first;
}

/// The position of the first vert that occurs earlier in the list, or the length of the list. Quadratic for lists as
/// short as most polys.
inline std::size_t first_repeated(const vert_id* verts, std::size_t n, std::vector<std::uint64_t>& scratch) {
  if (n > 32) return first_repeated_of_many(verts, n, scratch);
  for (std::size_t i = 1; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (verts[i] == verts[j]) return i;
  return n;
}

}  // namespace concino::detail
