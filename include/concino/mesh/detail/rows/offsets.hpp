// Offsets: where the rows of a flat array begin.
#pragma once

#include <concino/core/error.hpp>

#include <cassert>
#include <cstdint>
#include <limits>
#include <new>
#include <type_traits>
#include <vector>

namespace concino::detail {

using offsets = std::vector<std::uint32_t>;

/// Frees the unused capacity of a vector, unless it is small or there is no memory for a copy. This does not call
/// shrink_to_fit(), which takes longer to compile.
template<class T>
void shrink_if_wasteful(std::vector<T>& v) {
  static_assert(std::is_trivially_copyable_v<T>);
  if (v.capacity() <= v.size() + v.size() / 64) return;
  try {
    std::vector<T> exact;
    exact.assign(v.begin(), v.end());
    v.swap(exact);
  } catch (const std::bad_alloc&) {
    return;
  }
}

/// Turns counts[i + 1] = size of row i into the start of each row.
inline void prefix_sum(offsets& counts) {
  std::uint64_t sum = 0;
  for (std::uint32_t& c : counts) {
    sum += c;
    if (sum > std::numeric_limits<std::uint32_t>::max())
      throw unsupported("jagged_array: the mesh has more than 2^32 adjacencies of one kind");
    c = static_cast<std::uint32_t>(sum);
  }
}

}  // namespace concino::detail
