// Reads and writes base64, as in the XML files of VTK.
#pragma once

#include <concino/io/detail/text/characters.hpp>
#include <concino/io/text_sink.hpp>

#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace concino::detail {

inline constexpr char base64_digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// The value of each character; 0xFF: it is no digit.
inline constexpr std::array<std::uint8_t, 256> base64_values = [] {
  std::array<std::uint8_t, 256> all{};
  for (auto& x : all) x = 0xFF;
  for (unsigned i = 0; i < 64; ++i) all[static_cast<unsigned char>(base64_digits[i])] = static_cast<std::uint8_t>(i);
  return all;
}();

/// Decodes base64 piece by piece. Padding may end a group anywhere; the next characters then begin a new group. Blanks
/// are skipped.
class base64_reader {
  const char* at_;
  const char* end_;
  std::uint8_t rest_[2] = {};  // bytes of the last group that were not asked for yet
  unsigned num_rest_ = 0;

 public:
  base64_reader(const char* at, const char* end) : at_(at), end_(end) {}

  /// No fewer bytes than can be left.
  std::size_t max_left() const { return static_cast<std::size_t>(end_ - at_) / 4 * 3 + 3 + num_rest_; }
  const char* position() const { return at_; }

  /// Decodes n bytes. Returns false if the text ends or is no base64; position() is then there.
  bool read(unsigned char* to, std::size_t n) {
    while (n > 0 && num_rest_ > 0) {
      *to++ = rest_[0];
      rest_[0] = rest_[1];
      --num_rest_;
      --n;
    }
    const auto value = [&](std::ptrdiff_t k) -> std::uint32_t {
      return base64_values[static_cast<unsigned char>(at_[k])];
    };
    while (n > 0) {
      if (n >= 3 && end_ - at_ >= 4) {
        const std::uint32_t a = value(0), b = value(1), c = value(2), d = value(3);
        if ((a | b | c | d) < 64) {
          const std::uint32_t bits = a << 18 | b << 12 | c << 6 | d;
          to[0] = static_cast<unsigned char>(bits >> 16);
          to[1] = static_cast<unsigned char>(bits >> 8);
          to[2] = static_cast<unsigned char>(bits);
          to += 3, n -= 3, at_ += 4;
          continue;
        }
      }
      unsigned char group[3];
      const unsigned size = read_group(group);
      if (size == 0) return false;
      for (unsigned i = 0; i < size; ++i) {
        if (n > 0) *to++ = group[i], --n;
        else rest_[num_rest_++] = group[i];
      }
    }
    return true;
  }

 private:
  /// Decodes one group, with blanks and padding. Returns its size, 1 to 3, or 0.
  unsigned read_group(unsigned char* group) {
    std::uint32_t bits = 0;
    unsigned digits = 0, padding = 0;
    for (; digits + padding < 4; ++at_) {
      if (at_ == end_) return 0;
      if (is_space(*at_)) continue;
      const std::uint8_t v = base64_values[static_cast<unsigned char>(*at_)];
      if (*at_ == '=' && digits >= 2) ++padding;
      else if (v < 64 && padding == 0) ++digits;
      else return 0;
      bits = bits << 6 | (v & 63u & (padding ? 0u : 63u));
    }
    group[0] = static_cast<unsigned char>(bits >> 16);
    group[1] = static_cast<unsigned char>(bits >> 8);
    group[2] = static_cast<unsigned char>(bits);
    return digits - 1;
  }
};

}  // namespace concino::detail
