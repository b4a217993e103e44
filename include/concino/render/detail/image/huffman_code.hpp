// Huffman codes, and a writer of bits.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

class bit_writer {
  std::vector<std::uint8_t>& to_;
  std::uint64_t bits_ = 0;
  unsigned count_ = 0;

 public:
  explicit bit_writer(std::vector<std::uint8_t>& to) : to_(to) {}
  /// Appends the lowest `count` bits of a value, at most 32.
  void put(std::uint32_t value, unsigned count) {
    bits_ |= std::uint64_t{value} << count_;
    for (count_ += count; count_ >= 8; count_ -= 8, bits_ >>= 8) to_.push_back(static_cast<std::uint8_t>(bits_));
  }
  void fill_byte() { put(0, (8 - count_) % 8); }
};

/// A Huffman code: symbols with the lengths of their code words, and the words with the first bit lowest.
class huffman_code {
  std::vector<std::uint8_t> lengths_;
  std::vector<std::uint16_t> words_;

  /// The lengths for these counts, without a limit. At least two counts are not 0.
  static std::vector<std::uint8_t> best_lengths(const std::vector<std::uint32_t>& counts) {
    struct node {
      std::uint64_t count;
      std::size_t symbol, parent;
    };
    std::vector<node> nodes;  // leaves by count, then inner nodes, whose counts do not decrease either
    for (std::size_t s = 0; s < counts.size(); ++s)
      if (counts[s] > 0) nodes.push_back({counts[s], s, 0});
    std::stable_sort(nodes.begin(), nodes.end(), [](const node& a, const node& b) { return a.count < b.count; });
    const std::size_t leaves = nodes.size();
    std::size_t leaf = 0, inner = leaves;
    const auto take_least = [&] {
      const std::size_t i =
          leaf < leaves && (inner == nodes.size() || nodes[leaf].count <= nodes[inner].count) ? leaf++ : inner++;
      nodes[i].parent = nodes.size();
      return nodes[i].count;
    };
    while (nodes.size() < 2 * leaves - 1) {
      const std::uint64_t a = take_least(), b = take_least();
      nodes.push_back({a + b, 0, 0});
    }
    std::vector<std::uint8_t> depth(nodes.size(), 0), lengths(counts.size(), 0);
    for (std::size_t i = nodes.size() - 1; i-- > 0;) {
      depth[i] = static_cast<std::uint8_t>(depth[nodes[i].parent] + 1);
      if (i < leaves) lengths[nodes[i].symbol] = depth[i];
    }
    return lengths;
  }

 public:
  /// The code of a block in which symbol s occurs counts[s] times; no word is longer than `limit` bits.
  huffman_code(std::vector<std::uint32_t> counts, unsigned limit) {
    // A code of one word is incomplete, and some decoders reject it. So at least two symbols get a word.
    auto used = counts.size() - static_cast<std::size_t>(std::count(counts.begin(), counts.end(), 0u));
    for (std::size_t s = 0; used < 2; ++s)
      if (counts[s] == 0) counts[s] = 1, ++used;
    // Counts that differ less give shorter words.
    while (lengths_ = best_lengths(counts), *std::max_element(lengths_.begin(), lengths_.end()) > limit)
      for (std::uint32_t& c : counts)
        if (c > 0) c = c / 2 + 1;
    words_.resize(counts.size());
    unsigned word = 0;
    for (unsigned length = 1; length <= limit; ++length, word <<= 1)
      for (std::size_t s = 0; s < counts.size(); ++s)
        if (lengths_[s] == length) words_[s] = reversed(word++, length);
  }

  static std::uint16_t reversed(unsigned word, unsigned length) {
    unsigned r = 0;
    for (unsigned k = 0; k < length; ++k, word >>= 1) r = r << 1 | (word & 1);
    return static_cast<std::uint16_t>(r);
  }

  void write(bit_writer& to, std::size_t symbol) const { to.put(words_[symbol], lengths_[symbol]); }
  const std::vector<std::uint8_t>& lengths() const { return lengths_; }
};

}  // namespace concino::detail
