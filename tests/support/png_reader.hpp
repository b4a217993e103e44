// A reader of the PNG files that the library writes, for tests: it checks all that a strict decoder would. Slow and simple.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace concino::testing {

/// Expands zlib data as RFC 1950 and 1951 describe it, bit by bit.
class inflater {
  std::span<const std::uint8_t> from_;
  std::size_t bit_ = 16;
  std::vector<std::uint8_t> to_;

  static void need(bool ok, const char* what) {
    if (!ok) throw std::runtime_error(what);
  }

  struct code {
    std::vector<int> lengths;
    /// Whether the code words fill the tree, no more and no less.
    bool complete() const {
      double sum = 0;
      for (const int n : lengths) sum += n > 0 ? 1.0 / (1 << n) : 0;
      return sum == 1;
    }
  };

  unsigned bits(unsigned n) {
    unsigned x = 0;
    for (unsigned k = 0; k < n; ++k, ++bit_) {
      need(bit_ / 8 < from_.size(), "the data end too early");
      x |= (from_[bit_ / 8] >> (bit_ % 8) & 1u) << k;
    }
    return x;
  }

  int symbol(const code& c) {
    int word = 0, first = 0;
    for (int length = 1; length <= 15; ++length, first <<= 1) {
      word = word << 1 | static_cast<int>(bits(1));
      int count = 0;
      for (const int n : c.lengths) count += n == length;
      if (word - first < count) {
        for (std::size_t s = 0;; ++s)
          if (c.lengths[s] == length && word-- == first) return static_cast<int>(s);
      }
      first += count;
    }
    throw std::runtime_error("no such code word");
  }

  void block() {
    need(bits(2) == 2, "a block without codes of its own");
    const std::size_t literals = bits(5) + 257, distances = bits(5) + 1, known = bits(4) + 4;
    code c{std::vector<int>(19, 0)};
    const int order[] = {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};
    for (std::size_t k = 0; k < known; ++k) c.lengths[static_cast<std::size_t>(order[k])] = static_cast<int>(bits(3));
    need(c.complete(), "the code of lengths is incomplete");
    std::vector<int> all;
    while (all.size() < literals + distances) {
      const int s = symbol(c);
      const int x = s == 16 ? all.back() : s > 16 ? 0 : s;
      const unsigned n = s == 16 ? 3 + bits(2) : s == 17 ? 3 + bits(3) : s == 18 ? 11 + bits(7) : 1;
      all.insert(all.end(), n, x);
    }
    need(all.size() == literals + distances, "too many lengths");
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(literals);
    const code literal{{all.begin(), middle}}, distance{{middle, all.end()}};
    need(literal.complete() && distance.complete(), "a code is incomplete");
    const int extra[] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
    const int start[] = {3, 4, 5, 6, 7, 8, 9, 10, 11, 13, 15, 17, 19, 23, 27, 31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227, 258};
    for (int s; (s = symbol(literal)) != 256;) {
      if (s < 256) {
        to_.push_back(static_cast<std::uint8_t>(s));
        continue;
      }
      const unsigned n = static_cast<unsigned>(start[s - 257]) + bits(static_cast<unsigned>(extra[s - 257]));
      const unsigned d = static_cast<unsigned>(symbol(distance)), more = d < 4 ? 0 : d / 2 - 1;
      const std::size_t back = (d < 4 ? d + 1 : ((2 + d % 2) << more) + 1) + bits(more);
      need(back <= to_.size(), "a string begins before the data");
      for (unsigned k = 0; k < n; ++k) to_.push_back(to_[to_.size() - back]);
    }
  }

 public:
  explicit inflater(std::span<const std::uint8_t> from) : from_(from) {}
  std::vector<std::uint8_t> operator()() {
    need(from_.size() >= 6 && (from_[0] * 256 + from_[1]) % 31 == 0 && from_[0] == 0x78, "no zlib header");
    for (bool last = false; !last;) {
      last = bits(1);
      block();
    }
    std::uint32_t a = 1, b = 0;
    for (const std::uint8_t x : to_) a = (a + x) % 65521, b = (b + a) % 65521;
    bit_ = (bit_ + 7) / 8 * 8;
    std::uint32_t sum = 0;
    for (int k = 0; k < 4; ++k) sum = sum << 8 | bits(8);
    need(sum == (b << 16 | a) && bit_ == 8 * from_.size(), "the check sum is wrong, or bytes follow it");
    return to_;
  }
};

/// What a PNG file contains.
struct png_contents {
  std::size_t width = 0, height = 0, channels = 0;
  std::vector<std::uint8_t> bytes;
  std::string chunks;  // their names
};

namespace detail {

inline std::uint32_t number_at(std::span<const std::uint8_t> s, std::size_t i) {
  return std::uint32_t{s[i]} << 24 | std::uint32_t{s[i + 1]} << 16 | std::uint32_t{s[i + 2]} << 8 | s[i + 3];
}

inline void unfilter(png_contents& png, const std::vector<std::uint8_t>& rows) {
  const std::size_t c = png.channels, size = png.width * c;
  if (rows.size() != (size + 1) * png.height) throw std::runtime_error("too few or too many rows");
  png.bytes.resize(size * png.height);
  for (std::size_t y = 0; y < png.height; ++y)
    for (std::size_t i = 0; i < size; ++i) {
      std::uint8_t* const at = png.bytes.data() + y * size + i;
      const int left = i >= c ? at[-static_cast<std::ptrdiff_t>(c)] : 0, above = y > 0 ? at[-static_cast<std::ptrdiff_t>(size)] : 0;
      const int corner = i >= c && y > 0 ? at[-static_cast<std::ptrdiff_t>(size + c)] : 0;
      const int pa = std::abs(above - corner), pb = std::abs(left - corner), pc = std::abs(left + above - 2 * corner);
      const int predictions[] = {0, left, above, (left + above) / 2, pa <= pb && pa <= pc ? left : pb <= pc ? above : corner};
      *at = static_cast<std::uint8_t>(rows[y * (size + 1) + i + 1] + predictions[rows[y * (size + 1)]]);
    }
}

}  // namespace detail

/// Errors: std::runtime_error if the file is not as the specification demands.
inline png_contents read_png(std::span<const std::uint8_t> file) {
  const auto need = [](bool ok, const char* what) {
    if (!ok) throw std::runtime_error(what);
  };
  need(file.size() > 8 && std::string_view(reinterpret_cast<const char*>(file.data()), 8) == "\x89PNG\r\n\x1a\n", "no PNG file");
  png_contents png;
  std::vector<std::uint8_t> data;
  for (std::size_t i = 8; i < file.size();) {
    need(i + 12 <= file.size(), "a chunk is cut off");
    const std::size_t n = detail::number_at(file, i);
    need(n <= file.size() - i - 12, "a chunk is too long");
    std::uint32_t crc = ~0u;
    for (std::size_t k = i + 4; k < i + 8 + n; ++k) {
      crc ^= file[k];
      for (int b = 0; b < 8; ++b) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0u);
    }
    need(~crc == detail::number_at(file, i + 8 + n), "the check sum of a chunk is wrong");
    const std::string name(reinterpret_cast<const char*>(file.data()) + i + 4, 4);
    const auto content = file.subspan(i + 8, n);
    png.chunks += name + ' ';
    if (name == "IHDR") {
      need(n == 13 && content[8] == 8 && (content[9] == 2 || content[9] == 6), "another kind of picture");
      png.width = detail::number_at(content, 0);
      png.height = detail::number_at(content, 4);
      png.channels = content[9] == 2 ? 3 : 4;
    }
    if (name == "IDAT") data.insert(data.end(), content.begin(), content.end());
    i += 12 + n;
  }
  detail::unfilter(png, inflater(data)());
  return png;
}

}  // namespace concino::testing
