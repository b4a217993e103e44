// Adapter for compressed .vtu and .vtp files through zlib.
// Needs: zlib (Debian: zlib1g-dev), linked by -lz.
//
//   auto m = concino::load<concino::polyhedralmesh>("x.vtu", {.inflate = concino::zlib_inflate});
#pragma once

#include <concino/io/options.hpp>

#include <cstddef>
#include <type_traits>

#include <zlib.h>

namespace concino {

/// Decompresses zlib data.
/// Needs:  n bytes at `from`, room for `size` bytes at `to`.
/// Result: whether the data are valid and have exactly this size; else what is at `to` is unspecified.      Cost: O(n +
///         size).
/// Errors: none.
inline bool zlib_inflate(const unsigned char* from, std::size_t n, unsigned char* to, std::size_t size) {
  uLong used = static_cast<uLong>(n);
  uLongf written = static_cast<uLongf>(size);
  if (used != n || written != size) return false;  // where zlib counts in 32 bits
  return uncompress2(to, &written, from, &used) == Z_OK && used == n && written == size;
}
static_assert(std::is_same_v<decltype(&zlib_inflate), inflate_function>);

}  // namespace concino
