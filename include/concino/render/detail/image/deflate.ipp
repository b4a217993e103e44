// Defines deflate.hpp: repeated strings by hash chains, then Huffman codes for each block.
#pragma once

#include <concino/render/detail/image/deflate.hpp>
#include <concino/render/detail/image/huffman_code.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace concino::detail {

/// The first length or distance of each of deflate's classes, and the number of bits that follow.
template<std::size_t N>
struct deflate_classes {
  std::array<std::uint16_t, N> first{};
  std::array<std::uint8_t, N> bits{};

  /// Four classes with no bits, then `each` classes with 1 bit, as many with 2 bits ...; twice as many with no bits.
  constexpr deflate_classes(unsigned start, unsigned each) {
    unsigned next = start;
    for (std::size_t k = 0; k < N; ++k) {
      bits[k] = static_cast<std::uint8_t>(k < 2 * each ? 0 : k / each - 1);
      first[k] = static_cast<std::uint16_t>(next);
      next += 1u << bits[k];
    }
  }

  std::size_t operator()(unsigned value) const {
    return static_cast<std::size_t>(std::upper_bound(first.begin(), first.end(), value) - first.begin()) - 1;
  }
};

inline constexpr deflate_classes<30> distance_classes(1, 2);
inline constexpr deflate_classes<29> length_classes = [] {
  deflate_classes<29> c(3, 4);
  c.first[28] = 258;  // the longest has a class of its own
  c.bits[28] = 0;
  return c;
}();

/// A string that occurred `distance` bytes before; or, with distance 0, the byte `length`.
struct deflate_symbol {
  std::uint16_t length, distance;
};

/// Finds earlier occurrences of the bytes at a position.
class string_finder {
  static constexpr std::uint32_t window_ = 1 << 15;
  static constexpr unsigned shortest_ = 3, longest_ = 258, tries_ = 8;
  std::span<const std::uint8_t> bytes_;
  std::vector<std::uint32_t> last_ = std::vector<std::uint32_t>(window_, 0);  // by hash: 1 + the last position, 0: none
  std::vector<std::uint32_t> before_ =
      std::vector<std::uint32_t>(window_, 0);  // by position modulo the window: the one before with the same hash

  std::size_t hash(std::size_t i) const {
    const std::uint32_t three = bytes_[i] | std::uint32_t{bytes_[i + 1]} << 8 | std::uint32_t{bytes_[i + 2]} << 16;
    return (three * 2654435761u) >> 17;
  }

 public:
  explicit string_finder(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  void add(std::size_t i) {
    if (i + shortest_ > bytes_.size()) return;
    std::uint32_t& last = last_[hash(i)];
    before_[i % window_] = last;
    last = static_cast<std::uint32_t>(i + 1);
  }

  /// The longest string at i that occurs before, among the last few with the same hash; of length 0 if there is none.
  deflate_symbol longest(std::size_t i) const {
    deflate_symbol best{0, 0};
    if (i + shortest_ > bytes_.size()) return best;
    const std::size_t end = std::min<std::size_t>(longest_, bytes_.size() - i);
    const std::uint8_t* const here = bytes_.data() + i;
    std::uint32_t other = last_[hash(i)], nearer = 0;
    for (unsigned k = 0; k < tries_ && other != 0; ++k) {
      // exact beyond 2^32 bytes too, as it is small
      const std::uint32_t distance = static_cast<std::uint32_t>(i + 1) - other;
      if (distance <= nearer || distance >= window_ || distance > i) break;      // an old entry, overwritten since
      nearer = distance;
      const std::uint8_t* const there = here - distance;
      std::size_t n = 0;
      while (n < end && here[n] == there[n]) ++n;
      // Three bytes are shorter than a distance of many bits.
      if (n > best.length && n >= shortest_ && !(n == shortest_ && distance > 4096))
        best = {static_cast<std::uint16_t>(n), static_cast<std::uint16_t>(distance)};
      if (n == end) break;
      other = before_[(other - 1) % window_];
    }
    return best;
  }
};

inline void write_code_lengths(bit_writer& out, const huffman_code& literals, const huffman_code& distances) {
  std::vector<std::uint8_t> lengths = literals.lengths();
  lengths.insert(lengths.end(), distances.lengths().begin(), distances.lengths().end());
  struct run {
    std::uint8_t symbol, extra, bits;
  };
  std::vector<run> runs;
  std::vector<std::uint32_t> counts(19, 0);
  const auto add = [&](unsigned symbol, std::size_t extra, unsigned bits) {
    runs.push_back(
        {static_cast<std::uint8_t>(symbol), static_cast<std::uint8_t>(extra), static_cast<std::uint8_t>(bits)});
    ++counts[symbol];
  };
  for (std::size_t i = 0; i < lengths.size();) {
    const std::uint8_t x = lengths[i];
    std::size_t n = 1;
    while (i + n < lengths.size() && n < 138 && lengths[i + n] == x) ++n;
    i += n;
    if (x == 0 && n >= 11) add(18, n - 11, 7);
    else if (x == 0 && n >= 3) add(17, n - 3, 3);
    else {
      add(x, 0, 0);
      --n;
      for (; n >= 3; n -= std::min<std::size_t>(n, 6)) add(16, std::min<std::size_t>(n, 6) - 3, 2);
      for (; n > 0; --n) add(x, 0, 0);
    }
  }
  const huffman_code code(counts, 7);
  constexpr std::array<std::uint8_t, 19> order = {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};
  out.put(static_cast<std::uint32_t>(literals.lengths().size() - 257), 5);
  out.put(static_cast<std::uint32_t>(distances.lengths().size() - 1), 5);
  out.put(19 - 4, 4);
  for (const std::uint8_t s : order) out.put(code.lengths()[s], 3);
  for (const run& r : runs) {
    code.write(out, r.symbol);
    out.put(r.extra, r.bits);
  }
}

inline void write_block(bit_writer& out, std::span<const deflate_symbol> symbols, bool last) {
  std::vector<std::uint32_t> literal_counts(286, 0), distance_counts(30, 0);
  for (const auto& [length, distance] : symbols) {
    ++literal_counts[distance == 0 ? length : 257 + length_classes(length)];
    if (distance != 0) ++distance_counts[distance_classes(distance)];
  }
  constexpr std::size_t end = 256;
  literal_counts[end] = 1;
  const huffman_code literals(literal_counts, 15), distances(distance_counts, 15);
  out.put(last, 1);
  out.put(2, 2);  // a block with codes of its own
  write_code_lengths(out, literals, distances);
  for (const auto& [length, distance] : symbols) {
    if (distance == 0) {
      literals.write(out, length);
      continue;
    }
    const std::size_t l = length_classes(length), d = distance_classes(distance);
    literals.write(out, 257 + l);
    out.put(static_cast<std::uint32_t>(length - length_classes.first[l]), length_classes.bits[l]);
    distances.write(out, d);
    out.put(static_cast<std::uint32_t>(distance - distance_classes.first[d]), distance_classes.bits[d]);
  }
  literals.write(out, end);
}

inline std::uint32_t adler32(std::span<const std::uint8_t> bytes) {
  std::uint32_t a = 1, b = 0;
  for (std::size_t i = 0; i < bytes.size();) {
    // as many as do not overflow
    for (const std::size_t end = std::min(bytes.size(), i + 5552); i < end; ++i) b += a += bytes[i];
    a %= 65521;
    b %= 65521;
  }
  return b << 16 | a;
}

CONCINO_INLINE std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t block = 1 << 16;  // symbols
  constexpr unsigned long_enough = 64;    // no longer string is looked for at the next byte
  std::vector<std::uint8_t> to = {0x78, 0xda};
  bit_writer out(to);
  string_finder find(bytes);
  std::vector<deflate_symbol> symbols;
  symbols.reserve(block);
  deflate_symbol here{0, 0};
  for (std::size_t i = 0; i < bytes.size();) {
    find.add(i);
    deflate_symbol next{0, 0};
    if (here.length < long_enough) next = find.longest(i + 1);
    if (here.length == 0 || next.length > here.length) {
      symbols.push_back({bytes[i], 0});
      ++i;
      here = next;
    } else {
      symbols.push_back(here);
      for (std::size_t k = 1; k < here.length; ++k) find.add(i + k);
      i += here.length;
      here = find.longest(i);
    }
    if (symbols.size() < block) continue;
    write_block(out, symbols, false);
    symbols.clear();
  }
  write_block(out, symbols, true);
  out.fill_byte();
  const std::uint32_t check = adler32(bytes);
  for (const unsigned shift : {24u, 16u, 8u, 0u}) to.push_back(static_cast<std::uint8_t>(check >> shift));
  return to;
}

}  // namespace concino::detail
