// Adapter for compressed .vtu and .vtp files through zlib.
// Needs: zlib (Debian: zlib1g-dev), linked by -lz.
//
//   auto m = concino::load<concino::polyhedralmesh>("x.vtu", {.inflate = concino::zlib_inflate});
#pragma once

#include <concino/io/options.hpp>

#include <algorithm>
#include <cstddef>
#include <type_traits>

#include <zlib.h>

namespace concino {

/// Decompresses zlib data.
/// Needs:  n bytes at `from`, room for `size` bytes at `to`.
/// Result: whether the data are valid and have exactly this size; else what is at `to` is unspecified.      Cost: O(n + size).
/// Errors: none.
inline bool zlib_inflate(const unsigned char* from, std::size_t n, unsigned char* to, std::size_t size) {
  constexpr std::size_t most = std::size_t{1} << 30;  // zlib counts in 32 bits
  z_stream z{};
  if (inflateInit(&z) != Z_OK) return false;
  int state = Z_OK;
  unsigned char end = 0;  // where zlib writes if the data are larger
  while (state == Z_OK) {
    if (z.avail_in == 0) {
      const std::size_t part = std::min(n, most);
      z.next_in = const_cast<unsigned char*>(from);
      z.avail_in = static_cast<uInt>(part);
      from += part;
      n -= part;
    }
    if (z.avail_out == 0) {
      const std::size_t part = std::min(size, most);
      z.next_out = part ? to : &end;
      z.avail_out = part ? static_cast<uInt>(part) : 1;
      to += part;
      size -= part;
    }
    state = inflate(&z, Z_NO_FLUSH);
    if (z.next_out == &end + 1) state = Z_DATA_ERROR;
  }
  const bool is_whole = state == Z_STREAM_END && size == 0 && (z.avail_out == 0 || z.next_out == &end) && z.avail_in == 0 && n == 0;
  inflateEnd(&z);
  return is_whole;
}
static_assert(std::is_same_v<decltype(&zlib_inflate), inflate_function>);

}  // namespace concino
