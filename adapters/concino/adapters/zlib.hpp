// Adapter for compressed .vtu and .vtp files through zlib.
// Needs: zlib (Debian: zlib1g-dev), linked by -lz.
//
//   auto m = concino::load<concino::polyhedralmesh>("x.vtu", {.inflate = concino::zlib_inflate});
#pragma once

#include <concino/io/options.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include <zlib.h>

namespace concino::detail {

/// The checksum of zlib data, Adler-32 (RFC 1950): the sum a of all bytes and 1, and the sum b of all values that a takes, modulo 65521. Sums of 8 columns
/// of bytes at a time, which processors add in parallel: zlib adds byte by byte, which is a tenth of its time.
inline std::uint32_t zlib_checksum(const unsigned char* bytes, std::size_t n) {
  typedef std::uint8_t byte8 __attribute__((vector_size(8)));  // with operators for each of its numbers
  typedef std::uint16_t short8 __attribute__((vector_size(16)));
  constexpr std::size_t columns = 8, most_rows = 21;  // 255 * 21 * 22 / 2 < 2^16
  std::uint32_t a = 1, b = 0;
  while (n >= columns) {
    const std::size_t rows = std::min(n / columns, most_rows);
    short8 sums = {}, sums_of_sums = {};
    for (std::size_t r = 0; r < rows; ++r, bytes += columns) {
      byte8 row;
      std::memcpy(&row, bytes, columns);
      sums += __builtin_convertvector(row, short8);
      sums_of_sums += sums;
    }
    b += static_cast<std::uint32_t>(rows * columns) * a;
    for (std::size_t i = 0; i < columns; ++i) {
      a += sums[i];
      b += static_cast<std::uint32_t>(columns * sums_of_sums[i] - i * sums[i]);
    }
    a %= 65521;
    b %= 65521;
    n -= rows * columns;
  }
  for (; n > 0; --n) b += a += *bytes++;
  return b % 65521 << 16 | a % 65521;
}

}  // namespace concino::detail

namespace concino {

/// Decompresses zlib data.
/// Needs:  n bytes at `from`, room for `size` bytes at `to`.
/// Result: whether the data are valid and have exactly this size; else what is at `to` is unspecified.      Cost: O(n + size).
/// Errors: none.
inline bool zlib_inflate(const unsigned char* from, std::size_t n, unsigned char* to, std::size_t size) {
  constexpr std::size_t most = std::size_t{1} << 30;  // zlib counts in 32 bits
  constexpr std::size_t header = 2, check = 4;        // RFC 1950
  if (n < header + check || (from[0] & 15) != Z_DEFLATED || from[0] >> 4 > 7 || (from[0] * 256 + from[1]) % 31 != 0 || (from[1] & 32)) return false;
  const unsigned char *const inflated = to, *const sum = from + n - check;
  const std::size_t inflated_size = size;
  from += header;
  n -= header + check;
  z_stream z{};
  if (inflateInit2(&z, -MAX_WBITS) != Z_OK) return false;  // without header and checksum
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
    state = inflate(&z, n == 0 && size == 0 ? Z_FINISH : Z_NO_FLUSH);  // if it is the last call, zlib need not copy what may be repeated later
    if (z.next_out == &end + 1) state = Z_DATA_ERROR;
  }
  const bool is_whole = state == Z_STREAM_END && size == 0 && (z.avail_out == 0 || z.next_out == &end) && z.avail_in == 0 && n == 0;
  inflateEnd(&z);
  return is_whole && detail::zlib_checksum(inflated, inflated_size) == (std::uint32_t{sum[0]} << 24 | std::uint32_t{sum[1]} << 16 | std::uint32_t{sum[2]} << 8 | sum[3]);
}
static_assert(std::is_same_v<decltype(&zlib_inflate), inflate_function>);

}  // namespace concino
